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

/// A word as lower-case hexadecimal digits, one for every four bits.
std::string hex(std::uint64_t word, int bits);

/// numerator / denominator as decimal text. A fraction that has more digits is cut off after
/// `digits`, and an ellipsis follows.
/// @pre the denominator is not 0
std::string decimal_text(const oracle::Integer& numerator, const oracle::Integer& denominator,
                         std::size_t digits);

/// The lines of a request.
std::vector<std::string_view> lines_of(std::string_view text);

/// The words of a line, which single spaces separate, each up to eight hexadecimal digits. Empty if
/// there is anything else.
std::vector<std::uint32_t> hex_words(std::string_view line);

}  // namespace fixproof::web
