/// @file
/// What a solver is asked of one routine.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "verify/proof/specification.hpp"
#include "verify/variant.hpp"
#include "x86model/routine.hpp"

namespace fixproof {

/// SMT-LIB scripts, one or two for each path through `code`, that are unsatisfiable, all of them,
/// exactly where `code` does what the specification of `variant` says for every operand: the same
/// words, #DE exactly where it says, no undefined flag read, no memory but its own touched, and SI,
/// DI, BP and SP kept. Each ends by asking for the operands.
/// @param code the whole program; any, a broken one too
/// @throws std::logic_error where the 8088 transforms do not bring the FixedMul along that is
/// proven by itself
std::vector<std::string> questions(const Variant& variant,
                                   std::span<const x86model::Instruction> code,
                                   Arithmetic arithmetic = Arithmetic::abstract);

/// Whether `code` computes, path for path, the very terms that the routine of `variant` does: then
/// the two are equivalent, and no solver need be asked.
bool has_same_terms(const Variant& variant, std::span<const x86model::Instruction> code);

/// The operands in a solver's answer to such a script; empty where it holds none.
std::vector<std::uint32_t> operands_in(const Variant& variant, const std::string& answer);

}  // namespace fixproof
