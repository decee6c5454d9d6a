/// @file
/// How a target says what it has found.
#pragma once

#include <optional>
#include <string>

namespace fixproof::fuzz {

/// Writes `text` to standard error and aborts, which every fuzzer takes for a crash and keeps the
/// input of.
[[noreturn]] void report_finding(const std::string& text);

/// Reports what there is to report.
inline void demand_none(const std::optional<std::string>& finding) {
  if (finding) report_finding(*finding);
}

}  // namespace fixproof::fuzz
