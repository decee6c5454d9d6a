/// @file
/// The findings of a judge as text.
#pragma once

#include <string>

#include "judge/check/judge.hpp"

namespace fixproof::check {

/// Returns the words in hex and, in parentheses, their values; the operand of a conversion
/// likewise.
std::string text_of_operands(const JudgedCase& one, const Rules& rules);

/// Returns one line with the case, the expected and the actual result, and the exact result.
std::string text_of(const JudgedCase& one, const Rules& rules);

/// Returns the operands of a case as they stand on a line of `fixproof gen`.
std::string line_of_operands(const JudgedCase& one, const Rules& rules);

/// Returns what a result is as a line that `fixproof check` reads.
std::string line_of_result(Said said, const cases::Format& format);

/// Returns the kind of a case: where its exact result lies, and whether it fits.
CaseKind kind_of(const JudgedCase& one, const Rules& rules);

/// Returns what the rules expect of a case. A rule of a program takes the words as they are.
Expected expected_of(const JudgedCase& one, const Rules& rules);

/// Returns the counts by kind of case, the first wrong cases, what the wrong cases have in common,
/// and the rules that the subject follows. Requires at least one judged case.
std::string verdict_text(const Judge& judge);

}  // namespace fixproof::check
