/// @file
/// The rules that a subject seems to follow.
#pragma once

#include "judge/check/judge.hpp"

namespace fixproof::check {

/// The number of cases that find the rounding. All cases are then judged by it.
inline constexpr std::uint64_t cases_for_guess = 20'000;

/// Returns the rules of a judge with the rounding that fits its cases best. A program's own rule
/// tells more than a rounding with exceptions, unless the user says what to expect of an overflow
/// or without a result.
Rules fitting_rules(const Judge& guess);

}  // namespace fixproof::check
