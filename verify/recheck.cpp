#include "verify/recheck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/plain_text.hpp"
#include "verify/chunk_runner.hpp"

namespace fixproof::verify {

namespace {

std::string text_of(const ChunkResult& result) {
  return fmt::format("{} mismatches, {} #DE, answers {:016x}", support::grouped(result.mismatches),
                     support::grouped(result.faults), result.answers);
}

}  // namespace

void recheck(const Report& report, std::span<const parties::Party* const> parties,
             std::size_t count) {
  std::vector<std::uint64_t> done;
  for (std::uint64_t chunk = 0; chunk < report.done.size(); ++chunk) {
    if (report.done[chunk]) done.push_back(chunk);
  }
  // Seeded by the system, so that no editor of a report knows which chunks run again.
  std::mt19937_64 random(std::random_device{}());
  std::vector<std::uint64_t> chosen;
  std::sample(done.begin(), done.end(), std::back_inserter(chosen), count, random);

  const PartiesByRow by_row = parties_by_row(report.plan, parties);
  ChunkRunner runner(report.plan, by_row, 0);
  for (const std::uint64_t chunk : chosen) {
    const ChunkFindings found = runner.run(chunk);
    const ChunkResult again{found.findings.faults, found.findings.mismatches, found.answers};
    if (again == report.chunks[chunk]) continue;
    const cases::Chunk place = report.plan.chunk(chunk);
    throw std::runtime_error(fmt::format(
        "chunk {} ({}, {}) has results that differ from those computed here: {}; run again: {}",
        chunk, cases::name_of(report.plan.rows()[place.job->row].variant),
        cases::name_of(place.job->stream), text_of(report.chunks[chunk]), text_of(again)));
  }
}

}  // namespace fixproof::verify
