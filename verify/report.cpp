#include "verify/report.hpp"

#include <algorithm>
#include <tuple>

#include "verify/cases/plan.hpp"

namespace fixproof::verify {

namespace {

std::uint64_t sum_of(const std::vector<Findings>& rows, std::uint64_t Findings::*count) {
  std::uint64_t sum = 0;
  for (const Findings& row : rows) sum += row.*count;
  return sum;
}

}  // namespace

void Findings::add(const Findings& other, std::size_t most) {
  cases += other.cases;
  faults += other.faults;
  mismatches += other.mismatches;
  shown.insert(shown.end(), other.shown.begin(), other.shown.end());
  std::sort(shown.begin(), shown.end(), [](const Mismatch& a, const Mismatch& b) {
    return std::tie(a.chunk, a.index) < std::tie(b.chunk, b.index);
  });
  if (shown.size() > most) shown.resize(most);
}

Report::Report(cases::Plan plan_, cases::Shard shard_, std::size_t max_shown_)
    : plan(std::move(plan_)),
      shard(shard_),
      max_shown(max_shown_),
      done(plan.chunks()),
      chunks(plan.chunks()),
      findings(plan.rows().size()) {}

void Report::add(std::uint64_t chunk, const ChunkFindings& found) {
  findings[plan.chunk(chunk).job->row].add(found.findings, max_shown);
  chunks[chunk] = {found.findings.faults, found.findings.mismatches, found.answers};
  done[chunk] = true;
}

void Report::add(const Maker& maker) {
  if (std::find(makers.begin(), makers.end(), maker) == makers.end()) makers.push_back(maker);
}

std::uint64_t Report::chunks_done() const {
  return static_cast<std::uint64_t>(std::count(done.begin(), done.end(), true));
}

std::uint64_t Report::chunks_in_shard() const {
  const std::uint64_t before = shard.index - 1;
  return plan.chunks() <= before ? 0 : (plan.chunks() - before - 1) / shard.count + 1;
}

std::uint64_t Report::cases() const { return sum_of(findings, &Findings::cases); }

std::uint64_t Report::mismatches() const { return sum_of(findings, &Findings::mismatches); }

}  // namespace fixproof::verify
