/// @file
/// A number as a person types it: decimal, hexadecimal or bits. The command and the playground read
/// it here. docs/formats.md has the rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/decimal.hpp"
#include "verify/cases/format.hpp"

namespace fixproof::input {

/// Whether hexadecimal digits without `0x` are a word. In the command they are, if they are as many
/// as the word has; decimal digits after a leading 0 are an error there, because such a number may
/// be a word that lost a digit.
enum class Bare : std::uint8_t { word, decimal };

struct Number {
  std::string error{};    ///< what is wrong with the text; empty if it is right
  oracle::Ratio exact{};  ///< the exact number
  std::string decimal{};  ///< decimal text without `_`, with `-` as sign; empty for a word
  bool is_word = false;   ///< units of the format, after 0x or 0b or as a bare word
};

/// The length of the longest text that is accepted.
inline constexpr std::size_t longest = 100;
/// The largest exponent that is accepted, and the least without its sign.
inline constexpr int largest_exponent = 100;

/// Reads a decimal number such as `-1.5`, `1_000` or `2e-3`, or units of the format after `0x` or
/// `0b`. Without a sign, these are the bits of a word; after a sign, they are a magnitude.
Number number_of(std::string_view text, const cases::Format& format, Bare bare);

/// Returns the parts of a line between spaces, tabs, commas and semicolons.
std::vector<std::string_view> parts_of(std::string_view line);

}  // namespace fixproof::input
