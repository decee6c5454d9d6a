/// @file
/// The verdict of `fixproof check` as JSON; docs/judging.md has its members.
#pragma once

#include <string>

#include "judge/check/judge.hpp"
#include "support/json.hpp"

namespace fixproof::cli {

/// @param text the verdict as text
/// @param complete every case was judged
support::Json check_json(const check::Judge& judge, const std::string& text, bool complete);

}  // namespace fixproof::cli
