/// @file
/// Numbers as people read them, and foreign text made safe to print.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fixproof::support {

/// 1234567 as 1,234,567.
std::string grouped(std::uint64_t number);

/// A duration in one or two units: 8.3 s, 4 min 20 s, 2 h 05 min.
std::string duration(double seconds);

/// `text` with `?` in place of each control character and each mark that changes the direction of
/// writing, so that it cannot steer a terminal.
std::string printable(const std::string& text);

/// Foreign text as an error message quotes it: at most 40 characters, on one line, printable.
std::string quoted(std::string_view text);

}  // namespace fixproof::support
