/// @file
/// Reports as JSON: the form in which they are kept, resumed and merged.
#pragma once

#include <string>
#include <string_view>

#include "verify/report.hpp"

namespace fixproof::verify {

/// The report as indented JSON text. `done` lists the chunks that are done by their places in the
/// shard (0 for its first chunk), as pairs of first and last place.
std::string to_json(const Report& report);

/// The report that was written by to_json().
/// @throws std::runtime_error saying in what the text is no such report: counts that contradict the
/// chunks said to be done are found as well
Report from_json(std::string_view text);

/// Empty if both reports are of the same verification (level, seed, rows, parties, mismatches
/// kept), else what differs, such as "seed 1, not 2": `a` first.
std::string difference(const Report& a, const Report& b);

}  // namespace fixproof::verify
