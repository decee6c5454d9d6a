#include "judge/check/results.hpp"

#include <fmt/format.h>

#include "support/read_line.hpp"
#include "support/usage_error.hpp"

namespace fixproof::check {

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
      throw support::UsageError(
          fmt::format("a blank line is not a result; {}", result_format(format_, decimal_)));
    }
    return decimal_ ? parse_decimal_result(text_, format_) : parse_result(text_, format_);
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format("{}, line {}: {}", name_, line_, error.what()));
  }
}

}  // namespace fixproof::check
