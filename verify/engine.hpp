/// @file
/// Asks the parties and compares what they say.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cases/plan.hpp"
#include "parties/party.hpp"
#include "verify/report.hpp"

namespace fixproof::verify {

struct RunOptions {
  /// 0: one for each processor.
  unsigned threads = 0;
  /// Where set and true, threads end with the chunk they are at.
  const std::atomic<bool>* stop = nullptr;
  /// Called with the state reached, every `observe_every`, on the thread that called run().
  /// Smallest cases are sought only at the end.
  std::function<void(const Report&)> observe = nullptr;
  std::chrono::milliseconds observe_every{200};
};

/// Runs the chunks of the report's shard that are not done, adding what they find. `parties` holds
/// at least those that the rows of the plan name. What a party throws comes out of here.
/// @throws std::invalid_argument if a party of the plan is missing
void run(Report& report, std::span<const parties::Party* const> parties,
         const RunOptions& options = {});

/// Runs a whole plan. Keeps 10 mismatches of each row.
Report run(const cases::Plan& plan, std::span<const parties::Party* const> parties,
           const RunOptions& options = {});

}  // namespace fixproof::verify
