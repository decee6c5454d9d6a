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

#include "verify/party.hpp"
#include "verify/plan.hpp"
#include "verify/report.hpp"

namespace fixproof {

/// What one party says of one case.
struct Answer {
  Ending ending = Ending::broken;
  std::vector<std::uint32_t> words;  ///< empty unless the case ended in a value

  /// Lower-case hex digits of each word, single spaces between; or DE, or how else it ended.
  [[nodiscard]] std::string text(int word_bits) const;
  friend bool operator==(const Answer&, const Answer&) = default;
};

/// Asks one party one case.
Answer ask(const Party& party, const Variant& variant, std::span<const std::uint32_t> words);

/// Whether the answers of a case are all alike, and a value or #DE: parties that agree on a broken
/// program have verified nothing.
bool agree(std::span<const Answer> answers);

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
void run(Report& report, std::span<const Party* const> parties, const RunOptions& options = {});

/// Runs a whole plan. Keeps 10 mismatches of each row.
Report run(const Plan& plan, std::span<const Party* const> parties, const RunOptions& options = {});

}  // namespace fixproof
