/// @file
/// The rules that `judge` judges by, from its options and as text.
#pragma once

#include <string>

#include "app/cli/judge_options.hpp"
#include "judge/check/rules.hpp"

namespace fixproof::cli {

/// Tells whether results have several words, which `judge` alone judges.
bool is_whole(cases::Operation operation);

/// Tells whether no option says how results are rounded.
bool is_open(const JudgeOptions& options);

/// @throws support::UsageError for an option that does not apply or that names no rule
check::Rules rules_of(const JudgeOptions& options, const cases::Variant& variant);

/// Where the rounding of a verdict comes from.
enum class Rounding { given, fitting, unknown };

std::string rules_line(const check::Rules& rules, Rounding rounding);

}  // namespace fixproof::cli
