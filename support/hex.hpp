/// @file
/// Words in lower-case hex digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fixproof::support {

/// Parses a word of exactly `digits` lower-case hex digits, at most 16.
/// @throws UsageError naming the defect
std::uint64_t parse_long_hex(std::string_view text, std::size_t digits);

/// The same for at most 8 digits.
/// @throws UsageError naming the defect
std::uint32_t parse_hex(std::string_view text, std::size_t digits);

void append_hex(std::string& to, std::uint32_t word, std::size_t digits);

}  // namespace fixproof::support
