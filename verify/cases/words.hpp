/// @file
/// Conversion between words and text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "verify/cases/variant.hpp"

namespace fixproof::cases {

/// Returns the exact value of `magnitude` units of the format, and half a unit more if `and_half`.
/// In a decimal scale the fraction has all its digits.
std::string decimal_of(std::uint64_t magnitude, const Format& format, bool and_half = false);

/// Parses the operands of one case into words_in(v) words. The line has one group of hex digits per
/// operand, separated by single spaces, each the integer that stores a word.
/// @throws UsageError describing the defect of the line
void parse_words(std::string_view line, const Variant& v, std::span<std::uint32_t> words);

/// Formats numbers of `bits` bits in hex digits, separated by single spaces. Numbers of 64 bits
/// are pairs of words, the low half first.
std::string hex_words(std::span<const std::uint32_t> words, int bits);

/// Appends the same.
void append_words(std::string& to, std::span<const std::uint32_t> words, int bits);

/// Appends the operands of one case as parse_words() reads them; for from_decimal a decimal number.
void append_operands(std::string& to, const Variant& v, std::span<const std::uint32_t> words);

/// Formats the operands in decimal, angles in degrees. Values of more than 32 bits are exact,
/// others have enough places to distinguish them; for 16.16 five.
std::string decimal_words(const Variant& variant, std::span<const std::uint32_t> words);

}  // namespace fixproof::cases
