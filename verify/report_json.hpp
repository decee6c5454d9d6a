/// @file
/// Reports as JSON, the format in which they are stored, resumed and merged.
#pragma once

#include <string>
#include <string_view>

#include "verify/report.hpp"

namespace fixproof::verify {

/// Returns the report as indented JSON. `done` lists the finished chunks as pairs of first and last
/// position in the shard, counted from 0.
std::string to_json(const Report& report);

/// Reads the output of to_json().
/// @throws std::runtime_error if the text is not a report, or if its counts contradict its list of
/// finished chunks; the message names the defect
Report from_json(std::string_view text);

/// Returns the first difference between two verifications (level, seed, rows, parties, mismatches
/// kept), such as "seed 1, not 2" with the value of `a` first, or "" if there is none.
std::string difference(const Report& a, const Report& b);

}  // namespace fixproof::verify
