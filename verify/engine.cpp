#include "verify/engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "cases/plan.hpp"
#include "parties/answer.hpp"
#include "verify/chunk_runner.hpp"
#include "verify/shrink.hpp"

namespace fixproof::verify {

namespace {

/// The parties of each row, by the names that the plan gives.
std::vector<std::vector<const parties::Party*>> seat(
    const cases::Plan& plan, std::span<const parties::Party* const> parties) {
  std::vector<std::vector<const parties::Party*>> rows;
  for (const cases::Row& row : plan.rows()) {
    auto& seated = rows.emplace_back();
    for (const std::string& name : row.parties) {
      const auto found =
          std::find_if(parties.begin(), parties.end(),
                       [&](const parties::Party* party) { return party->name() == name; });
      if (found == parties.end()) {
        throw std::invalid_argument(fmt::format("no party '{}'", name));
      }
      seated.push_back(*found);
    }
  }
  return rows;
}

/// Seeks the smallest case for each mismatch that has none yet.
void explain(Report& report, const std::vector<std::vector<const parties::Party*>>& parties) {
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
      mismatch.smallest = shrink(mismatch.words, cases::operand_bits(variant),
                                 [&](auto words) { return !parties::agree(answers_to(words)); });
      const auto answers = answers_to(mismatch.smallest);
      for (std::size_t i = 0; i < answers.size(); ++i) {
        mismatch.said.emplace_back(parties[row][i]->name(),
                                   answers[i].text(2 * variant.fraction_bits));
      }
    }
  }
}

/// The threads of a run: each takes the next chunk that is not done until none is left.
class Workers {
 public:
  Workers(Report& report, const std::vector<std::vector<const parties::Party*>>& parties,
          const RunOptions& options)
      : report_(report), parties_(parties), options_(options) {
    for (std::uint64_t chunk = 0; chunk < report.done.size(); ++chunk) {
      if (report.shard.has(chunk) && !report.done[chunk]) left_.push_back(chunk);
    }
    unsigned threads = options.threads;
    if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
    // `running_` goes down as soon as the first threads end: it is no bound for this loop.
    const std::size_t started = std::min<std::size_t>(threads, left_.size());
    running_ = started;
    try {
      for (std::size_t i = 0; i < started; ++i) {
        threads_.emplace_back([this] { work(); });
      }
    } catch (const std::system_error& error) {
      failed_ = true;
      wait();
      throw std::runtime_error(fmt::format("cannot start thread {} of {}: {}; give fewer --threads",
                                           threads_.size() + 1, started, error.code().message()));
    }
  }

  ~Workers() { wait(); }
  Workers(const Workers&) = delete;
  Workers(Workers&&) = delete;
  Workers& operator=(const Workers&) = delete;
  Workers& operator=(Workers&&) = delete;

  /// Waits until all threads have ended, or for `time`. @return whether they have ended
  bool wait_for(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, time, [this] { return running_ == 0; });
  }

  /// The state now.
  [[nodiscard]] Report state() {
    const std::lock_guard lock(mutex_);
    return report_;
  }

  /// Waits for the end; throws what a party has thrown.
  void finish() {
    wait();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void wait() {
    // Whoever observes may throw as well.
    if (std::uncaught_exceptions() > 0) failed_ = true;
    for (auto& thread : threads_) {
      if (thread.joinable()) thread.join();
    }
  }

  [[nodiscard]] bool stopped() const {
    return failed_ || (options_.stop != nullptr && *options_.stop);
  }

  void work() {
    try {
      ChunkRunner runner(report_.plan, parties_, report_.max_shown);
      while (!stopped()) {
        const std::size_t next = next_++;
        if (next >= left_.size()) break;
        const std::uint64_t number = left_[next];
        const Findings found = runner.run(number);
        const std::lock_guard lock(mutex_);
        report_.findings[report_.plan.chunk(number).job->row].add(found, report_.max_shown);
        report_.done[number] = true;
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failed_ = true;
      failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    if (--running_ == 0) ended_.notify_all();
  }

  Report& report_;
  const std::vector<std::vector<const parties::Party*>>& parties_;
  const RunOptions& options_;
  std::vector<std::uint64_t> left_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::condition_variable ended_;
  std::size_t running_ = 0;
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace

void run(Report& report, std::span<const parties::Party* const> parties,
         const RunOptions& options) {
  const auto seated = seat(report.plan, parties);
  const auto begin = std::chrono::steady_clock::now();
  const double before = report.seconds;
  const auto seconds = [&] {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    return before + passed.count();
  };
  {
    Workers workers(report, seated, options);
    while (!workers.wait_for(options.observe_every)) {
      if (!options.observe) continue;
      Report state = workers.state();
      state.seconds = seconds();
      options.observe(state);
    }
    workers.finish();
  }
  explain(report, seated);
  report.seconds = seconds();
}

Report run(const cases::Plan& plan, std::span<const parties::Party* const> parties,
           const RunOptions& options) {
  Report report(plan, cases::Shard{}, 10);
  run(report, parties, options);
  return report;
}

}  // namespace fixproof::verify
