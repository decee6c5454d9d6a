/// @file
/// Names of C++ functions as sources write them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fixproof::judge {

/// Returns each name as its source has it, such as `n::f(int, int)` for `_ZN1n1fEii`; a name of
/// another language, and one that is too long, as it is. A confined process takes the names apart,
/// because those of a hostile file may take any time and memory.
std::vector<std::string> as_in_source(const std::vector<std::string>& names);

/// Tells whether a user means a function: `wanted` is its name as in the source, with or without
/// its parameters and the arguments of its template, and with any spaces.
bool is_meant(std::string_view wanted, std::string_view in_source);

}  // namespace fixproof::judge
