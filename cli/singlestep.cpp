#include "cli/singlestep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <stdexcept>

#include "singlestep/judge.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

using singlestep::Differences;
using singlestep::Skip;

/// Mismatches printed per file; further ones are only counted.
constexpr std::uint64_t max_shown = 20;

struct Counts {
  std::uint64_t equal = 0;
  std::uint64_t differing = 0;
  std::array<std::uint64_t, singlestep::skip_count> skipped{};

  [[nodiscard]] std::uint64_t run() const { return equal + differing; }
};

std::string summary(const Counts& counts) {
  std::uint64_t skipped = 0;
  std::string reasons;
  for (std::size_t i = 0; i < counts.skipped.size(); ++i) {
    if (counts.skipped[i] == 0) continue;
    skipped += counts.skipped[i];
    reasons += fmt::format("{} {} {}", reasons.empty() ? ":" : ",", counts.skipped[i],
                           name_of(static_cast<Skip>(i)));
  }
  return fmt::format("{} cases, {} run, {} equal, {} differing; {} skipped{}",
                     counts.run() + skipped, counts.run(), counts.equal, counts.differing, skipped,
                     reasons);
}

void count(const singlestep::Case& c, x86model::Target cpu, const std::string& file,
           Counts& counts) {
  const auto verdict = judge(c, cpu);
  if (const Skip* reason = std::get_if<Skip>(&verdict)) {
    ++counts.skipped[static_cast<std::size_t>(*reason)];
    return;
  }
  const auto& differences = std::get<Differences>(verdict);
  if (differences.empty()) {
    ++counts.equal;
    return;
  }
  if (++counts.differing > max_shown) return;
  std::cout << fmt::format("{}: case {} {}: {}\n", file, c.index, fixproof::support::quoted(c.name),
                           fmt::join(differences, "; "));
}

}  // namespace

int judge_files(const std::vector<std::string>& files, x86model::Target cpu) {
  bool differs = false;
  bool bad = false;
  for (const std::string& path : files) {
    const std::string file = support::printable(path);
    Counts counts;
    try {
      singlestep::read_cases(path, cpu,
                             [&](const singlestep::Case& c) { count(c, cpu, file, counts); });
      if (counts.differing > max_shown) {
        std::cout << fmt::format("{}: {} more\n", file, counts.differing - max_shown);
      }
      std::cout << fmt::format("{}: {}\n", file, summary(counts)) << std::flush;
      if (counts.run() == 0) throw support::UsageError(path + ": none of its cases can be run");
    } catch (const std::runtime_error& error) {
      std::cout << std::flush;
      fmt::print(stderr, "fixproof: {}\n", support::printable(error.what()));
      bad = true;
    }
    differs = differs || counts.differing > 0;
  }
  if (differs) return 1;
  return bad ? 2 : 0;
}

}  // namespace fixproof::cli
