#include "verify/check/results.hpp"

#include <fmt/format.h>

#include "verify/check/cases.hpp"
#include "verify/hex.hpp"
#include "verify/usage_error.hpp"

namespace fixproof {

Said parse_result(std::string_view line) {
  if (line == "DE") return std::nullopt;
  try {
    return parse_hex(line, 8);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format(
        "{}; a result is 8 lower-case hex digits, or DE for a divide error", error.what()));
  }
}

std::optional<Said> Results::next() {
  if (!next_line(in_, name_, text_, line_)) return std::nullopt;
  try {
    return parse_result(text_);
  } catch (const UsageError& error) {
    throw UsageError(fmt::format("{}, line {}: {}", name_, line_, error.what()));
  }
}

}  // namespace fixproof
