/// @file
/// Merges the reports of shards of one verification.
#pragma once

#include <span>
#include <string>

#include "verify/report.hpp"

namespace fixproof::verify {

struct NamedReport {
  std::string name;
  Report report;
};

/// Adds the parts up to a report of the whole. `parts` must not be empty.
/// @throws std::runtime_error if the parts belong to different verifications or share a chunk, or,
///         unless `accept_other_builds`, if this build or the same parties did not make them all
Report merged(std::span<const NamedReport> parts, bool accept_other_builds = false);

/// Returns one line that names the missing shards, by the finest division among the parts, or "".
std::string missing(const Report& sum, std::span<const NamedReport> parts);

}  // namespace fixproof::verify
