#include "verify/engine.hpp"

#include <algorithm>
#include <boost/noncopyable.hpp>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <utility>

#include "support/thread_pool.hpp"
#include "verify/cases/plan.hpp"
#include "verify/chunk_runner.hpp"
#include "verify/parties/answer.hpp"
#include "verify/shrink.hpp"

namespace fixproof::verify {

namespace {

/// Finds the smallest failing case for each mismatch that does not have one yet.
void explain(Report& report, const PartiesByRow& parties) {
  for (std::size_t row = 0; row < parties.size(); ++row) {
    const cases::Variant& variant = report.plan.rows()[row].variant;
    const auto answers_to = [&](std::span<const std::uint32_t> words) {
      std::vector<parties::Answer> answers;
      for (const parties::Party* party : parties[row])
        answers.push_back(parties::ask(*party, variant, words));
      return answers;
    };
    for (Mismatch& mismatch : report.findings[row].shown) {
      if (!mismatch.smallest.empty()) continue;
      // If a party fails, the mismatch stays as it is, to be explained by a later run.
      Mismatch explained = mismatch;
      explained.smallest = shrink(mismatch.words, cases::stored_bits(variant),
                                  [&](auto words) { return !parties::agree(answers_to(words)); });
      const auto answers = answers_to(explained.smallest);
      for (std::size_t i = 0; i < answers.size(); ++i) {
        explained.said.emplace_back(parties[row][i]->name(),
                                    answers[i].text(variant.format.word_bits));
      }
      mismatch = std::move(explained);
    }
  }
}

/// Runs the remaining chunks of a report. Each thread takes the next one until none is left.
class ChunkRun : private boost::noncopyable {
 public:
  ChunkRun(Report& report, const PartiesByRow& parties, const RunOptions& options)
      : report_(report), parties_(parties), options_(options) {
    for (std::uint64_t chunk = 0; chunk < report.done.size(); ++chunk) {
      if (report.shard.has(chunk) && !report.done[chunk]) left_.push_back(chunk);
    }
  }

  /// @param observe called on this thread with the current state, every `observe_every`
  void run(const std::function<void(Report)>& observe) {
    unsigned threads = options_.threads;
    if (threads == 0) threads = support::processors();
    running_ = std::min<std::size_t>(threads, left_.size());
    // Worker 0, the caller, does not run chunks.
    support::ThreadPool pool(running_ + 1);
    pool.run([&](std::size_t worker) {
      try {
        if (worker == 0) {
          while (!wait_for(options_.observe_every)) observe(state());
        } else {
          work();
        }
      } catch (...) {
        failed_ = true;
        if (worker != 0) leave();
        throw;
      }
      if (worker != 0) leave();
    });
  }

 private:
  /// Waits for `time`, or until no worker is running. @return whether all workers have ended
  bool wait_for(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, time, [this] { return running_ == 0; });
  }

  [[nodiscard]] Report state() {
    const std::lock_guard lock(mutex_);
    return report_;
  }

  [[nodiscard]] bool stopped() const {
    return failed_ || (options_.stop != nullptr && *options_.stop);
  }

  void work() {
    ChunkRunner runner(report_.plan, parties_, report_.max_shown);
    while (!stopped()) {
      const std::size_t next = next_++;
      if (next >= left_.size()) break;
      const std::uint64_t number = left_[next];
      const ChunkFindings found = runner.run(number);
      const std::lock_guard lock(mutex_);
      report_.add(number, found);
    }
  }

  void leave() {
    const std::lock_guard lock(mutex_);
    if (--running_ == 0) ended_.notify_all();
  }

  Report& report_;
  const PartiesByRow& parties_;
  const RunOptions& options_;
  std::vector<std::uint64_t> left_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::size_t running_ = 0;
};

}  // namespace

void run(Report& report, std::span<const parties::Party* const> parties,
         const RunOptions& options) {
  const auto by_row = parties_by_row(report.plan, parties);
  if (report.makers.empty() || !report.complete()) report.add(this_maker(report.plan, parties));
  const auto begin = std::chrono::steady_clock::now();
  const double before = report.seconds;
  const auto seconds = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return before + passed.count();
  };
  try {
    ChunkRun(report, by_row, options).run([&](Report state) {
      if (!options.observe) return;
      state.seconds = seconds();
      options.observe(state);
    });
    explain(report, by_row);
  } catch (...) {
    report.seconds = seconds();
    throw;
  }
  report.seconds = seconds();
}

Report run(const cases::Plan& plan, std::span<const parties::Party* const> parties,
           const RunOptions& options) {
  Report report(plan, cases::Shard{}, 10);
  run(report, parties, options);
  return report;
}

}  // namespace fixproof::verify
