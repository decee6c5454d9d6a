/// @file
/// What a person who made a slip may have meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fixproof::cli {

/// Returns `; did you mean NAME?` for the name that differs least from `given`, by at most two
/// letters that are left out, added, changed or swapped with the next one, and by fewer than half
/// of its letters. Returns nothing if there is none.
std::string suggestion(std::string_view given, const std::vector<std::string>& names);

}  // namespace fixproof::cli
