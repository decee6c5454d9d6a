/// @file
/// What a solver is asked of one routine.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cases/variant.hpp"
#include "proof/specification.hpp"
#include "x86model/routine.hpp"

namespace fixproof::proof {

/// SMT-LIB scripts. Where all of them are unsatisfiable, `code` does what the specification of
/// `variant` says for every operand: the same words, #DE exactly where it says, no undefined flag
/// read, no memory but its own touched, and what it must keep kept. For each path there is one that
/// says so, before it perhaps one that says that its products are the specification's, which the
/// next takes for granted; the last says that there are no operands but those of the paths. Under
/// abstract arithmetic a script may be satisfiable though `code` is right.
/// @param code the whole program; any, a broken one too
/// @throws std::logic_error where the 8088 transforms do not bring the FixedMul along that is
/// proven by itself
std::vector<std::string> questions(const cases::Variant& variant,
                                   std::span<const x86model::Instruction> code,
                                   Arithmetic arithmetic = Arithmetic::abstract);

/// Whether `code` computes, path for path, the very terms that the routine of `variant` does: then
/// the two are equivalent, and no solver need be asked.
bool has_same_terms(const cases::Variant& variant, std::span<const x86model::Instruction> code);

/// The operands in the model that a solver gives for such a script. One that it does not name may
/// be any: it is 0.
std::vector<std::uint32_t> operands_in(const cases::Variant& variant, const std::string& answer);

}  // namespace fixproof::proof
