/// @file
/// Every variant over spans of every length.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <vector>

#include "measure/stepping/stepping_span.hpp"
#include "measure/stepping/stepping_statistics.hpp"

namespace fixproof::measure {

/// Of one variant.
struct SteppingRow {
  SteppingVariant variant;
  SteppingStatistics statistics;
};

/// Case i of spans of so many pixels: what its ends are in even cases is extreme, in odd ones
/// random; of eight cases the first two go from centre to centre, and extreme places come with
/// extreme ends.
SpanPlace span_place(std::uint64_t seed, std::size_t pixels, std::uint64_t i);
Ends span_ends(std::uint64_t i);

/// Everything that is stepped, in the order of the tables.
std::vector<SteppingVariant> stepping_variants();

/// So many spans of each length from 1 to the longest, the same places for every variant.
/// @param done is told how many variants are
/// @return nothing where `stop` ended the run
std::vector<SteppingRow> measure_stepping_rows(const std::vector<SteppingVariant>& variants,
                                               std::uint64_t seed, std::uint64_t cases,
                                               const std::atomic<bool>& stop,
                                               const std::function<void(std::uint64_t)>& done);

}  // namespace fixproof::measure
