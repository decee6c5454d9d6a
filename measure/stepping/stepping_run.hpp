/// @file
/// Runs every variant over spans of every length.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "measure/stepping/stepping_span.hpp"
#include "measure/stepping/stepping_statistics.hpp"

namespace fixproof::measure {

struct SteppingRow {
  SteppingVariant variant;
  SteppingStatistics statistics;
};

/// The place and the kind of ends of case i for spans of `pixels` pixels. Even cases have extreme
/// ends, odd cases random ones. The first two of every eight cases go from centre to centre.
/// Extreme places only occur with extreme ends.
SpanPlace span_place(std::uint64_t seed, std::size_t pixels, std::uint64_t i);
Ends span_ends(std::uint64_t i);

/// All variants in the order of the tables.
std::vector<SteppingVariant> stepping_variants();

/// Measures `cases` spans of each length from 1 to the longest, at the same places for every
/// variant.
/// @param done called with the number of finished variants
/// @return nothing if `stop` ended the run
std::vector<SteppingRow> measure_stepping_rows(const std::vector<SteppingVariant>& variants,
                                               std::uint64_t seed, std::uint64_t cases,
                                               const std::atomic<bool>& stop,
                                               const std::function<void(std::uint64_t)>& done);

}  // namespace fixproof::measure
