/// @file
/// Words as the command line writes them: lower-case hex digits, all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fixproof {

/// A word of exactly `digits` lower-case hex digits.
/// @throws UsageError saying what is wrong with it
std::uint32_t parse_hex(std::string_view text, std::size_t digits);

void append_hex(std::string& to, std::uint32_t word, std::size_t digits);

/// Foreign text as an error message may quote it: short, on one line, and printable.
std::string quoted(std::string_view text);

}  // namespace fixproof
