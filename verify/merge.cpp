#include "verify/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "support/plain_text.hpp"
#include "verify/cases/plan.hpp"
#include "verify/report_json.hpp"

namespace fixproof::verify {

namespace {

/// A message names at most this many shards and counts the rest.
constexpr std::size_t max_named = 8;

void add(Report& sum, const NamedReport& part, std::span<const NamedReport> before) {
  for (std::uint64_t chunk = 0; chunk < sum.done.size(); ++chunk) {
    if (!part.report.done[chunk]) continue;
    if (sum.done[chunk]) {
      const auto other =
          std::find_if(before.begin(), before.end(),
                       [&](const NamedReport& earlier) { return earlier.report.done[chunk]; });
      throw std::runtime_error(
          other->name == part.name
              ? fmt::format("{} is given twice; name it once", part.name)
              : fmt::format("{} and {} both have chunk {}, which would count twice; leave one out",
                            other->name, part.name, chunk));
    }
    sum.done[chunk] = true;
    sum.chunks[chunk] = part.report.chunks[chunk];
  }
  for (std::size_t row = 0; row < sum.findings.size(); ++row) {
    sum.findings[row].add(part.report.findings[row], sum.max_shown);
  }
  sum.seconds += part.report.seconds;
  for (const Maker& maker : part.report.makers) sum.add(maker);
}

}  // namespace

Report merged(std::span<const NamedReport> parts, bool accept_other_builds) {
  const Report& first = parts.front().report;
  // Merging asks no party, so it may run on a machine whose parties have other identities.
  Maker wanted = this_build();
  if (!first.makers.empty()) wanted.parties = first.makers.front().parties;
  Report sum(first.plan, cases::Shard{}, first.max_shown);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string differs = difference(parts[i].report, first);
    if (!differs.empty()) {
      throw std::runtime_error(fmt::format("{} belongs to another verification than {}: {}",
                                           parts[i].name, parts.front().name, differs));
    }
    for (const Maker& maker : parts[i].report.makers) {
      const std::string other = difference(maker, wanted);
      if (other.empty() || accept_other_builds) continue;
      throw std::runtime_error(other_build(parts[i].name, other));
    }
    add(sum, parts[i], parts.first(i));
  }
  return sum;
}

std::string missing(const Report& sum, std::span<const NamedReport> parts) {
  if (sum.complete()) return "";
  std::uint64_t shards = 1;
  for (const NamedReport& part : parts) shards = std::max(shards, part.report.shard.count);
  std::vector<std::string> names;
  std::size_t missing_shards = 0;
  // Shards beyond the number of chunks are empty.
  for (std::uint64_t i = 1; i <= std::min<std::uint64_t>(shards, sum.done.size()); ++i) {
    std::uint64_t all = 0;
    std::uint64_t left = 0;
    for (std::uint64_t chunk = i - 1; chunk < sum.done.size(); chunk += shards) {
      ++all;
      if (!sum.done[chunk]) ++left;
    }
    if (left == 0) continue;
    if (++missing_shards > max_named) continue;
    names.push_back(left == all
                        ? fmt::format("shard {}/{}", i, shards)
                        : fmt::format("{} of {} chunks of shard {}/{}", support::grouped(left),
                                      support::grouped(all), i, shards));
  }
  std::string text = fmt::format("missing: {}", fmt::join(names, ", "));
  if (missing_shards > max_named)
    text += fmt::format(" and {} more shards", missing_shards - max_named);
  return text;
}

}  // namespace fixproof::verify
