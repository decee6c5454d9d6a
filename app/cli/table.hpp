/// @file
/// Text form of a verification report.
#pragma once

#include <string>

#include "verify/report.hpp"

namespace fixproof::cli {

/// Returns the table, one line per mismatch, the totals and the verdict.
std::string table(const verify::Report& report);

/// Formats the answers to one case on one line and groups parties that agree, as in
/// `model 00000001, oracle fast type 00000002`.
std::string grouped_answers(const std::vector<std::pair<std::string, std::string>>& said);

}  // namespace fixproof::cli
