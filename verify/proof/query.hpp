/// @file
/// The questions to a solver about one routine.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "verify/cases/variant.hpp"
#include "verify/proof/specification.hpp"
#include "x86model/routine.hpp"

namespace fixproof::proof {

/// Returns SMT-LIB scripts. If all of them are unsatisfiable, `code` meets the specification of
/// `variant` for every operand: it returns the same words, raises #DE exactly where specified,
/// reads no undefined flag, touches only its own memory and preserves the registers that it must.
/// One script per path states this. Another may precede it, which states that the path's products
/// equal those of the specification; the script of the path then assumes so. The last script states
/// that the paths cover all operands. Under abstract arithmetic a script may be satisfiable
/// although `code` is correct.
/// @param code the whole program, which may be broken
/// @throws std::logic_error if an 8088 transform includes a different FixedMul from the one that is
/// proven separately
std::vector<std::string> questions(const cases::Variant& variant,
                                   std::span<const x86model::Instruction> code,
                                   Arithmetic arithmetic = Arithmetic::abstract);

/// Returns whether every path computes the same terms as in the routine of `variant`. If so, the
/// two are equivalent without asking a solver. False for an 8088 transform with another FixedMul.
bool has_same_terms(const cases::Variant& variant, std::span<const x86model::Instruction> code);

/// Returns the operands in a model of one of these scripts: see fault_of_model().
std::vector<std::uint32_t> operands_in(const cases::Variant& variant, const std::string& model);

}  // namespace fixproof::proof
