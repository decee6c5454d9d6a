/// @file
/// Adds the reports of parts of one verification.
#pragma once

#include <span>
#include <string>

#include "verify/report.hpp"

namespace fixproof::verify {

/// A report and the name under which messages speak of it.
struct NamedReport {
  std::string name;
  Report report;
};

/// The sum, as a report of the whole. There is at least one part.
/// @throws std::runtime_error if a part is of another verification, or parts share a chunk
Report merged(std::span<const NamedReport> parts);

/// What the sum lacks, by the finest division into shards among the parts: one line; empty if
/// complete.
std::string missing(const Report& sum, std::span<const NamedReport> parts);

}  // namespace fixproof::verify
