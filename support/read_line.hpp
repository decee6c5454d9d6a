/// @file
/// Input line by line, of which none may fill the memory.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace fixproof::support {

/// Far more than any command's line has.
inline constexpr std::size_t longest_line = 4096;

/// The next line without its end, which is LF or CR LF. False at the end of the input.
/// @throws UsageError where the line is longer than `longest_line`, or the input cannot be read
bool read_line(std::istream& in, std::string& line);

/// Whether a line says nothing: it is blank or starts with #.
bool says_nothing(std::string_view line);

}  // namespace fixproof::support
