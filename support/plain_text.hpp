/// @file
/// Formats numbers for people, and makes foreign text safe to print.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fixproof::support {

/// Formats 1234567 as 1,234,567.
std::string grouped(std::uint64_t number);

/// Formats a duration in one or two units: 8.3 s, 4 min 20 s, 2 h 05 min.
std::string duration(double seconds);

/// Replaces each control character and each mark that changes the text direction by `?`, so that
/// the text cannot control a terminal.
std::string printable(std::string_view text);

/// Replaces each byte that is not printable ASCII by `?`.
std::string printable_ascii(std::string_view text);

/// Quotes foreign text for an error message: at most 40 characters, on one line, printable.
std::string quoted(std::string_view text);

}  // namespace fixproof::support
