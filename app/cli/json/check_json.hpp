/// @file
/// The verdict of `fixproof check` as JSON; docs/json.md has its members.
#pragma once

#include <string>

#include "judge/check/judge.hpp"
#include "support/json.hpp"

namespace fixproof::cli {

/// Returns a case with the expected and the given result, but not its number.
support::Json answer_json(const check::JudgedCase& one, const check::Rules& rules);

/// @param text the verdict as text
/// @param complete every case was judged
support::Json check_json(const check::Judge& judge, const std::string& text, bool complete);

}  // namespace fixproof::cli
