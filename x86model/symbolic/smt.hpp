/// @file
/// Terms as SMT-LIB 2 text, in the theory of bit vectors with uninterpreted functions.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "x86model/symbolic/term.hpp"

namespace x86model::symbolic {

/// All terms that `roots` depend on. A term is made after its arguments: their order is one of
/// definition.
std::set<Term> reached_from(const Terms& terms, std::span<const Term> roots);

/// What a term is called in the text of define(): a constant as itself, a variable by its name.
std::string name_in_smt(const Terms& terms, Term term);

/// Lines that define every term that `roots` depend on, each once, before it is used. Variables and
/// applied functions are declared elsewhere.
std::string define(const Terms& terms, std::span<const Term> roots);

/// `(declare-const …)` for the variables among what `roots` depend on, in the order of their names.
std::string declare_variables(const Terms& terms, std::span<const Term> roots);

}  // namespace x86model::symbolic
