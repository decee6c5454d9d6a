/// @file
/// Words as the command line writes them: lower-case hex digits, all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "verify/variant.hpp"

namespace fixproof {

/// A word of exactly `digits` lower-case hex digits.
/// @throws UsageError saying what is wrong with it
std::uint32_t parse_hex(std::string_view text, std::size_t digits);

/// The operands of one case: exactly as many words as the operation takes, single spaces between.
/// @throws UsageError saying what is wrong with the line
void parse_words(std::string_view line, const Variant& v, std::span<std::uint32_t> words);

void append_hex(std::string& to, std::uint32_t word, std::size_t digits);

/// Text of any origin without what steers a terminal: control characters are shown as ?.
std::string printable(const std::string& text);

/// Foreign text as an error message may quote it: short, on one line, and printable.
std::string quoted(std::string_view text);

}  // namespace fixproof
