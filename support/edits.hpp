/// @file
/// How far apart two names are, and which one a person who made a slip may have meant.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fixproof::support {

/// Returns the number of characters to leave out, add, change or swap with the next one in `a` to
/// make it `b` (optimal string alignment).
std::size_t edits_between(std::string_view a, std::string_view b);

/// Returns `; did you mean NAME?` for the name that is the fewest edits from `given`, at most two
/// and fewer than half of its letters, or for the only name that `given` begins. Returns nothing if
/// there is none.
std::string suggestion(std::string_view given, const std::vector<std::string>& names);

}  // namespace fixproof::support
