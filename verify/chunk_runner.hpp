/// @file
/// Runs one chunk: the innermost loop of a verification.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "verify/party.hpp"
#include "verify/plan.hpp"
#include "verify/report.hpp"

namespace fixproof {

/// The buffers of one thread.
class ChunkRunner {
 public:
  /// `parties` holds those of each row of the plan. Both must outlive the runner.
  ChunkRunner(const Plan& plan, const std::vector<std::vector<const Party*>>& parties,
              std::size_t max_shown);

  /// Makes the cases of a chunk, asks the parties of its row and compares them with the first.
  Findings run(std::uint64_t number);

 private:
  /// Answers of one party to the cases at hand.
  struct Answers {
    std::vector<std::uint32_t> out;
    std::vector<Ending> endings;
  };

  void compare(const Variant& variant, std::span<const Party* const> parties, std::size_t cases);

  const Plan& plan_;
  const std::vector<std::vector<const Party*>>& parties_;
  std::size_t max_shown_;
  std::vector<std::uint32_t> in_;
  Answers judged_;
  Answers other_;
  /// For each case, whether somebody differs from the judged party.
  std::vector<std::uint8_t> differs_;
};

}  // namespace fixproof
