/// @file
/// Words and exact numbers as text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/integer.hpp"

namespace fixproof::web {

/// Returns a word as lower-case hexadecimal digits, one for every four bits.
std::string hex(std::uint64_t word, int bits);

/// Returns numerator / denominator as decimal text. A longer fraction is cut off after `digits`
/// digits and followed by an ellipsis.
/// @pre the denominator is not 0
std::string decimal_text(const oracle::Integer& numerator, const oracle::Integer& denominator,
                         std::size_t digits);

/// Returns the lines of a request.
std::vector<std::string_view> lines_of(std::string_view text);

}  // namespace fixproof::web
