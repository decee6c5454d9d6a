#include "check/results.hpp"

#include <fmt/format.h>

#include "support/hex.hpp"
#include "support/read_line.hpp"
#include "support/usage_error.hpp"

namespace fixproof::check {

namespace {

constexpr std::string_view result_format =
    "a result is 8 lower-case hex digits, or DE for a divide error";

}  // namespace

Said parse_result(std::string_view line) {
  if (line == "DE") return std::nullopt;
  try {
    return support::parse_hex(line, 8);
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format("{}; {}", error.what(), result_format));
  }
}

std::optional<Said> Results::next() {
  std::uint64_t blank = 0;
  try {
    do {
      ++line_;
      if (!support::read_line(in_, text_)) return std::nullopt;
      if (blank == 0 && !text_.starts_with('#') && support::is_blank_or_comment(text_))
        blank = line_;
    } while (support::is_blank_or_comment(text_));
    if (blank != 0) {
      line_ = blank;
      throw support::UsageError(fmt::format("a blank line is not a result; {}", result_format));
    }
    return parse_result(text_);
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format("{}, line {}: {}", name_, line_, error.what()));
  }
}

}  // namespace fixproof::check
