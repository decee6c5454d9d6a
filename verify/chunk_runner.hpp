/// @file
/// Runs one chunk: the innermost loop of a verification.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cases/plan.hpp"
#include "parties/party.hpp"
#include "verify/report.hpp"

namespace fixproof::verify {

/// Runs chunks one after the other on one thread and owns that thread's buffers.
class ChunkRunner {
 public:
  /// `parties` holds the parties of each row of the plan. Both references must outlive the runner.
  ChunkRunner(const cases::Plan& plan,
              const std::vector<std::vector<const parties::Party*>>& parties,
              std::size_t max_shown);

  /// Generates the cases of chunk `number` and compares each party of its row with the first.
  Findings run(std::uint64_t number);

 private:
  struct Answers {
    std::vector<std::uint32_t> out;
    std::vector<parties::Ending> endings;
  };

  void compare(const cases::Variant& variant, std::span<const parties::Party* const> parties,
               std::size_t cases);

  const cases::Plan& plan_;
  const std::vector<std::vector<const parties::Party*>>& parties_;
  std::size_t max_shown_;
  std::vector<std::uint32_t> in_;
  Answers judged_;
  Answers other_;
  /// For each case, whether any party differs from the judged one.
  std::vector<std::uint8_t> differs_;
};

}  // namespace fixproof::verify
