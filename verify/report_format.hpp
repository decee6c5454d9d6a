/// @file
/// What the writer and the reader of reports share.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"
#include "verify/report.hpp"

namespace fixproof::verify {

inline constexpr std::string_view format_name = "fixproof report";
/// Version 1 expected a carry in the printed 8088 ConcatXforms, so its rows differ. Version 2 does
/// not say what made it and has no digests.
inline constexpr std::uint64_t format_version = 3;

/// The streams of each row and their sizes, which reveal whether two builds generate the same
/// cases.
template <class AnyJson>
std::vector<AnyJson> streams_by_row(const cases::Plan& plan) {
  std::vector<AnyJson> rows(plan.rows().size(), AnyJson::object());
  for (const cases::Job& job : plan.jobs()) {
    rows[job.row][std::string(cases::name_of(job.stream))] = job.cases;
  }
  return rows;
}

/// Calls `use` with the place in the shard and the number of each chunk of the shard.
template <class Use>
void each_chunk(const Report& report, Use use) {
  for (std::uint64_t place = 0; place < report.chunks_in_shard(); ++place) {
    use(place, report.shard.index - 1 + place * report.shard.count);
  }
}

/// The line with the digest of all text before it, and the end of the report.
std::string seal_of(std::string_view text);

}  // namespace fixproof::verify
