/// @file
/// How far apart two names are.
#pragma once

#include <cstddef>
#include <string_view>

namespace fixproof::support {

/// Returns the number of characters to insert, delete or replace in `a` to make it `b`.
std::size_t edits_between(std::string_view a, std::string_view b);

}  // namespace fixproof::support
