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
  /// `fixproof verify --case` for the judged party and the first that answers otherwise, with all
  /// functions of libraries, because one may spoil the answers of others. If none answers
  /// otherwise, as the case was one of many in an array or a function keeps a state, `fixproof
  /// verify` for the whole row.
  std::string verify;
  std::string trace;     ///< `fixproof trace`; empty unless the model is compared and can be traced
  bool differs = false;  ///< Whether the parties answered the case differently alone.
};

/// The cases of a row.
struct RowCases {
  int level = 1;
  std::uint64_t seed = 1994;
};

/// Returns the commands for the smallest case of the mismatch, which was found among these cases.
Replay replay(const cases::Row& row, const Mismatch& mismatch, const RowCases& among = {});

}  // namespace fixproof::verify
