/// @file
/// Conversion between words and text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "cases/variant.hpp"

namespace fixproof::cases {

/// Parses the operands of one case: exactly words_in() words, separated by single spaces.
/// @throws UsageError describing the defect of the line
void parse_words(std::string_view line, const Variant& v, std::span<std::uint32_t> words);

/// Formats words of `bits` bits in hex digits, separated by single spaces.
std::string hex_words(std::span<const std::uint32_t> words, int bits);

/// Formats the operands in decimal, angles in degrees. Five places distinguish all 16.16 values.
std::string decimal_words(const Variant& variant, std::span<const std::uint32_t> words);

}  // namespace fixproof::cases
