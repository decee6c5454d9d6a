/// @file
/// A description of the rules that a subject follows.
#pragma once

#include <string>

#include "judge/check/judge.hpp"

namespace fixproof::check {

/// Returns a line each for the rounding, overflow, operands without a result, and the largest
/// error. If the subject breaks every rule, the line names the nearest one with its first
/// exceptions. If the cases cannot tell rules apart, the line names all of them. A further line
/// names an idiom of C that explains wrong results.
std::string guess_text(const Judge& judge);

/// Returns the index in roundings() of the rounding that the subject follows best. Roundings that
/// agree on roots in range can differ on the mirrored root of a negative operand: this is the one
/// with the fewest exceptions there.
std::size_t best_rounding(const Judge& judge);

}  // namespace fixproof::check
