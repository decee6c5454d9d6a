/// @file
/// The figures of the report as tables for other programs.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "support/json.hpp"

namespace fixproof::cli {

/// A table as RFC 4180 has it: lines end in CR LF; a field with a comma, a quote or a line end
/// stands in quotes, its quotes doubled.
/// @param rows a list of flat objects with the same keys, which become the first line; null is an
/// empty field. Empty for no rows.
std::string csv_text(const support::Json& rows);

/// All that csv_files() may write.
inline constexpr std::array csv_names{"accuracy.csv", "pixels.csv",   "clocks.csv", "claims.csv",
                                      "host.csv",     "vertices.csv", "drift.csv"};

/// `accuracy.csv` and so on, with their contents, from the report's data; nothing for what has not
/// been measured.
std::vector<std::pair<std::string, std::string>> csv_files(const support::Json& report);

}  // namespace fixproof::cli
