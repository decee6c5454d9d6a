#include "app/cli/singlestep.hpp"

#include <fmt/format.h>

#include <iostream>
#include <mutex>
#include <stdexcept>

#include "app/cli/json/singlestep_json.hpp"
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

std::string summary(const StepCounts& counts) {
  std::string reasons;
  for (std::size_t i = 0; i < counts.skipped.size(); ++i) {
    if (counts.skipped[i] == 0) continue;
    reasons += fmt::format("{} {} {}", reasons.empty() ? ":" : ",", counts.skipped[i],
                           name_of(static_cast<Skip>(i)));
  }
  return fmt::format("{} cases, {} run, {} equal, {} differing; {} skipped{}",
                     counts.run() + counts.all_skipped(), counts.run(), counts.equal,
                     counts.differing, counts.all_skipped(), reasons);
}

void count(const singlestep::Case& c, x86model::Cpu cpu, StepFile& file) {
  const auto verdict = fixproof::singlestep::judge(c, cpu);
  StepCounts& counts = file.counts;
  if (const Skip* reason = std::get_if<Skip>(&verdict)) {
    ++counts.skipped[static_cast<std::size_t>(*reason)];
    return;
  }
  const auto& differences = std::get<Differences>(verdict);
  if (differences.empty()) {
    ++counts.equal;
    return;
  }
  if (++counts.differing <= max_shown) file.shown.push_back({c.index, c.name, differences});
}

StepFile judge_file(const std::string& path, x86model::Cpu cpu) {
  StepFile file{.path = path, .counts = {}, .shown = {}, .error = {}};
  try {
    singlestep::read_cases(path, cpu, [&](const singlestep::Case& c) { count(c, cpu, file); });
  } catch (const std::runtime_error& error) {
    file.error = error.what();
  }
  return file;
}

std::string text_of(const StepFile& file) {
  const std::string name = support::printable(file.path);
  std::string text;
  for (const DifferingStep& step : file.shown) {
    text += fmt::format("{}: case {} {}: {}\n", name, step.index, support::quoted(step.name),
                        fmt::join(step.differences, "; "));
  }
  if (file.counts.differing > max_shown) {
    text += fmt::format("{}: {} more\n", name, file.counts.differing - max_shown);
  }
  if (file.error.empty()) text += fmt::format("{}: {}\n", name, summary(file.counts));
  return text;
}

/// Results in the order of the files, printed as soon as all earlier ones are.
class Results {
 public:
  explicit Results(std::size_t files) : files_(files), done_(files) {}

  void add(std::size_t number, StepFile file) {
    const std::scoped_lock lock(mutex_);
    done_[number] = true;
    files_[number] = std::move(file);
    for (; printed_ < files_.size() && done_[printed_]; ++printed_) {
      const StepFile& next = files_[printed_];
      std::cout << text_of(next) << std::flush;
      if (!next.error.empty()) print_error(next.error);
      total_ += next.counts;
      bad_ = bad_ || !next.error.empty();
    }
  }

  /// Prints what concerns all files. @return the exit status
  int finish() {
    if (files_.size() > 1) std::cout << "total: " << summary(total_) << '\n' << std::flush;
    if (!bad_ && total_.run() == 0) {
      print_error("none of the cases can be run");
      bad_ = true;
    }
    if (total_.differing > 0) return 1;
    return bad_ ? 2 : 0;
  }

  [[nodiscard]] support::Json json() const { return singlestep_json(files_, total_); }

 private:
  std::mutex mutex_;
  std::vector<StepFile> files_;
  std::vector<bool> done_;
  std::size_t printed_ = 0;
  StepCounts total_;
  bool bad_ = false;
};

}  // namespace

int judge_files(const std::vector<std::string>& files, x86model::Cpu cpu, ResultFile& result) {
  result.open(files, "--singlestep");
  Results results(files.size());
  support::for_each_in_threads(files.size(),
                               [&](std::size_t i) { results.add(i, judge_file(files[i], cpu)); });
  const int status = results.finish();
  return result.write(status, [&] { return results.json(); });
}

}  // namespace fixproof::cli
