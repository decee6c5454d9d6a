/// @file
/// Reports a finding of a target.
#pragma once

#include <optional>
#include <string>

namespace fixproof::fuzz {

/// Writes `text` to standard error and aborts, so that the fuzzer records a crash and keeps the
/// input.
[[noreturn]] void report_finding(const std::string& text);

/// Reports the finding, if there is one.
inline void report_if_any(const std::optional<std::string>& finding) {
  if (finding) report_finding(*finding);
}

}  // namespace fixproof::fuzz
