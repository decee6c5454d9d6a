/// @file
/// A report as people read it.
#pragma once

#include <string>

#include "verify/report.hpp"

namespace fixproof::cli {

/// The table, a line for each row; below it the mismatches, a line each; the totals and the
/// verdict.
std::string table(const verify::Report& report);

/// The answers to one case as text on one line, those who say the same together: `model 00000001,
/// oracle fast type 00000002`.
std::string grouped_answers(const std::vector<std::pair<std::string, std::string>>& said);

}  // namespace fixproof::cli
