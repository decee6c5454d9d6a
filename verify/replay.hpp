/// @file
/// Command lines that trace or repeat one case.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "verify/cases/plan.hpp"
#include "verify/cases/variant.hpp"
#include "verify/report.hpp"

namespace fixproof::verify {

/// The command that shows a case in the routine of a variant, instruction by instruction.
std::string trace_line(const cases::Variant& variant, std::span<const std::uint32_t> words);

/// The commands that repeat a mismatch, as a shell reads them.
struct Replay {
  std::string verify;  ///< `fixproof verify --case`
  std::string trace;   ///< `fixproof trace`; empty unless the model is compared and can be traced
  /// Whether `verify` is known to differ. It compares the judged party and the first that answers
  /// otherwise. If none does, as the case was one of many in an array, it compares all parties.
  bool differs = false;
};

/// Returns the commands for the smallest case of the mismatch.
Replay replay(const cases::Row& row, const Mismatch& mismatch);

}  // namespace fixproof::verify
