/// @file
/// Reports a finding of a target.
#pragma once

#include <optional>
#include <string>

namespace fixproof::fuzz {

/// Writes `text` to standard error and aborts, so that the fuzzer keeps the input as a crash.
[[noreturn]] void report_finding(const std::string& text);

inline void report_if_any(const std::optional<std::string>& finding) {
  if (finding) report_finding(*finding);
}

}  // namespace fixproof::fuzz
