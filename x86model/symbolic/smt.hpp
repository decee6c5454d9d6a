/// @file
/// Terms as SMT-LIB 2 text, in the theory of bit vectors with uninterpreted functions.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "x86model/symbolic/term.hpp"

namespace x86model::symbolic {

/// All terms that `roots` depend on, arguments before the terms that use them.
std::set<Term> reached_from(const Terms& terms, std::span<const Term> roots);

/// The name of a term in the output of define(): constants as literals, variables by name.
std::string name_in_smt(const Terms& terms, Term term);

/// Lines that define every term that `roots` depend on, each once and before its use. Does not
/// declare variables and abstract functions.
std::string define(const Terms& terms, std::span<const Term> roots);

/// `(declare-const …)` for the variables that `roots` depend on, sorted by name.
std::string declare_variables(const Terms& terms, std::span<const Term> roots);

}  // namespace x86model::symbolic
