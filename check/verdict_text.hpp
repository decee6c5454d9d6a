/// @file
/// What a judge has found, as people read it.
#pragma once

#include <string>

#include "check/judge.hpp"

namespace fixproof::check {

/// One line: the case, what was expected and what was said, and the exact result.
std::string text_of(const JudgedCase& one, const Rules& rules);

/// The counts by kind of case, the first wrong cases, and the rules the subject does follow. At
/// least one case must have been judged.
std::string verdict_text(const Judge& judge);

}  // namespace fixproof::check
