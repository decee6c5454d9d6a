/// @file
/// Which rules a subject follows, in words.
#pragma once

#include <string>

#include "check/judge.hpp"

namespace fixproof::check {

/// A line for the rounding, for overflow, for what has no result, and for the largest error. Where
/// no rule is kept everywhere, the nearest, with the first exceptions; where the cases cannot tell
/// rules apart, all of these.
std::string guess_text(const Judge& judge);

}  // namespace fixproof::check
