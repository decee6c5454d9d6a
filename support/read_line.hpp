/// @file
/// Reads input line by line with a limit on the length.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace fixproof::support {

/// Far longer than the input line of any command.
inline constexpr std::size_t longest_line = 4096;

/// Reads the next line without its LF or CR LF. @return false at the end of the input
/// @throws UsageError if the line is longer than `longest_line` or the input cannot be read
bool read_line(std::istream& in, std::string& line);

/// Returns whether a line is blank or starts with #.
bool is_blank_or_comment(std::string_view line);

}  // namespace fixproof::support
