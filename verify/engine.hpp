/// @file
/// Runs a plan: asks the parties and compares their answers.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "verify/cases/plan.hpp"
#include "verify/parties/party.hpp"
#include "verify/report.hpp"

namespace fixproof::verify {

struct RunOptions {
  /// 0 means one thread per processor.
  unsigned threads = 0;
  /// If set and true, each thread stops after its current chunk.
  const std::atomic<bool>* stop = nullptr;
  /// Called every `observe_every` on the thread that called run(), which computes the smallest
  /// cases only at the end.
  std::function<void(const Report&)> observe = nullptr;
  std::chrono::milliseconds observe_every{200};
};

/// Runs the remaining chunks of the report's shard and adds their findings. `parties` must include
/// every party that the plan names. After an exception the report holds the chunks that were
/// finished, as after a stop, and can go on. The chunk of the party that failed is not among them.
/// @throws parties::PartyFailure if a party fails, which ends the run; std::invalid_argument if a
/// party of the plan is missing
void run(Report& report, std::span<const parties::Party* const> parties,
         const RunOptions& options = {});

/// Runs a whole plan and keeps 10 mismatches per row.
Report run(const cases::Plan& plan, std::span<const parties::Party* const> parties,
           const RunOptions& options = {});

}  // namespace fixproof::verify
