#include "app/cli/singlestep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <iostream>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "app/cli/print_error.hpp"
#include "support/plain_text.hpp"
#include "support/thread_pool.hpp"
#include "verify/singlestep/judge.hpp"

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
  Counts& operator+=(const Counts& other) {
    equal += other.equal;
    differing += other.differing;
    for (std::size_t i = 0; i < skipped.size(); ++i) skipped[i] += other.skipped[i];
    return *this;
  }
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

/// What the command prints about one file.
struct Result {
  bool done = false;
  Counts counts;
  std::string out;
  std::string error;
};

void count(const singlestep::Case& c, x86model::Cpu cpu, const std::string& file, Result& result) {
  const auto verdict = fixproof::singlestep::judge(c, cpu);
  Counts& counts = result.counts;
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
  result.out += fmt::format("{}: case {} {}: {}\n", file, c.index, support::quoted(c.name),
                            fmt::join(differences, "; "));
}

Result judge_file(const std::string& path, x86model::Cpu cpu) {
  const std::string file = support::printable(path);
  Result result;
  try {
    singlestep::read_cases(path, cpu,
                           [&](const singlestep::Case& c) { count(c, cpu, file, result); });
  } catch (const std::runtime_error& error) {
    result.error = error.what();
  }
  const Counts& counts = result.counts;
  if (counts.differing > max_shown) {
    result.out += fmt::format("{}: {} more\n", file, counts.differing - max_shown);
  }
  if (result.error.empty()) result.out += fmt::format("{}: {}\n", file, summary(counts));
  return result;
}

/// Results in the order of the files, printed as soon as all earlier ones are.
class Results {
 public:
  explicit Results(std::size_t files) : results_(files) {}

  void add(std::size_t file, Result result) {
    const std::scoped_lock lock(mutex_);
    result.done = true;
    results_[file] = std::move(result);
    for (; printed_ < results_.size() && results_[printed_].done; ++printed_) {
      Result& next = results_[printed_];
      std::cout << next.out << std::flush;
      if (!next.error.empty()) print_error(next.error);
      total_ += next.counts;
      bad_ = bad_ || !next.error.empty();
      next.out.clear();
    }
  }

  /// Prints what concerns all files. @return the exit status
  int finish() {
    if (results_.size() > 1) std::cout << "total: " << summary(total_) << '\n' << std::flush;
    if (!bad_ && total_.run() == 0) {
      print_error("none of the cases can be run");
      bad_ = true;
    }
    if (total_.differing > 0) return 1;
    return bad_ ? 2 : 0;
  }

 private:
  std::mutex mutex_;
  std::vector<Result> results_;
  std::size_t printed_ = 0;
  Counts total_;
  bool bad_ = false;
};

}  // namespace

int judge_files(const std::vector<std::string>& files, x86model::Cpu cpu) {
  Results results(files.size());
  std::atomic<std::size_t> next = 0;
  support::ThreadPool pool(
      std::min<std::size_t>(files.size(), std::max(1U, std::thread::hardware_concurrency())));
  pool.run([&](std::size_t /*worker*/) {
    for (std::size_t i = next++; i < files.size(); i = next++) {
      results.add(i, judge_file(files[i], cpu));
    }
  });
  return results.finish();
}

}  // namespace fixproof::cli
