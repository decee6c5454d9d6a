/// @file
/// States in SMT-LIB what a rounded quotient must be, by the remainder of a divide that the routine
/// makes, so that a solver adds and compares but never multiplies.
#pragma once

#include <optional>
#include <span>

#include "judge/code/claim.hpp"
#include "x86model/symbolic/term.hpp"

namespace fixproof::judge {

/// A divide of the machine: q and r with dividend = q * divisor + r.
struct MachineDivide {
  x86model::symbolic::Term dividend;
  x86model::symbolic::Term divisor;
  x86model::symbolic::Term quotient;
  x86model::symbolic::Term remainder;
  bool is_signed = true;
};

/// Returns the only divide that terms depend on; nothing if there is none, or more than one.
std::optional<MachineDivide> divide_in(x86model::symbolic::Terms& terms,
                                       std::span<const x86model::symbolic::Term> roots);

/// What a divide does beyond the rules of `check`.
struct DivideRules {
  bool divides_by_whole_part = false;  ///< the truncated divisor, which may be zero
  bool faults_beyond_bits = false;     ///< if the truncated magnitude has more bits than a word
  bool has_zero_by_zero = false;       ///< 0 / 0 is 0, not also the highest word
};

/// Returns the claim for div of operands a and b, to stand after the definitions of the terms. Its
/// definitions assert what holds for every division of integers: the remainder is smaller than the
/// divisor and has the sign of the dividend, and the quotient has the sign of the exact one and is
/// not larger than the dividend. They also define `cut`, the rounded quotient modulo the range, and
/// `lacks`, `fits` and `found`: whether there is no quotient, it is in range, and it was found near
/// the machine's. Returns nothing if the rules need more than inequalities tell.
/// @param divide nothing if the path has none: then only a result without a quotient can be right
/// @param halves whether the machine's quotient is near twice the result, not near the result
std::optional<Claim> quotient_claim(const check::Rules& rules,
                                    const x86model::symbolic::Terms& terms,
                                    const std::optional<MachineDivide>& divide, bool halves,
                                    const DivideRules& more = {});

}  // namespace fixproof::judge
