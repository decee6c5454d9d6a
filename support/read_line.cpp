#include "support/read_line.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "support/usage_error.hpp"

namespace fixproof::support {

bool read_line(std::istream& in, std::string& line) {
  // Leaves room for a CR and the terminating zero of getline().
  std::array<char, longest_line + 2> buffer;
  errno = 0;
  in.getline(buffer.data(), buffer.size());
  if (in.bad()) {
    const std::string why = errno == 0 ? "" : ": " + std::generic_category().message(errno);
    throw UsageError("cannot be read" + why);
  }
  if (in.fail() && in.gcount() == 0) return false;
  // gcount() includes the LF, which is missing at the end of the input.
  const auto length = static_cast<std::size_t>(in.gcount()) - (in.eof() || in.fail() ? 0 : 1);
  line.assign(buffer.data(), length);
  if (line.ends_with('\r') && !in.eof()) line.pop_back();
  if (in.fail() || line.size() > longest_line) {
    throw UsageError(fmt::format("the line is longer than {} characters", longest_line));
  }
  return true;
}

bool is_blank_or_comment(std::string_view line) {
  return line.starts_with('#') || line.find_first_not_of(" \t\r") == std::string_view::npos;
}

}  // namespace fixproof::support
