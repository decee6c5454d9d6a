/// @file
/// The operands and results of a case as text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "cases/variant.hpp"

namespace fixproof::cases {

/// Reads the operands of one case: exactly as many words as the operation takes, separated by
/// single spaces.
/// @throws UsageError naming the defect of the line
void parse_words(std::string_view line, const Variant& v, std::span<std::uint32_t> words);

/// Words of `bits` bits in hex digits, separated by single spaces.
std::string hex_words(std::span<const std::uint32_t> words, int bits);

/// The operands in decimal, to five places, which tell all 16.16 values apart; angles in degrees.
std::string decimal_words(const Variant& variant, std::span<const std::uint32_t> words);

}  // namespace fixproof::cases
