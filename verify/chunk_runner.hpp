/// @file
/// Runs one chunk: the innermost loop of a verification.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "verify/answer_digest.hpp"
#include "verify/cases/plan.hpp"
#include "verify/parties/party.hpp"
#include "verify/report.hpp"

namespace fixproof::verify {

using PartiesByRow = std::vector<std::vector<const parties::Party*>>;

/// Finds the parties of each row of the plan.
/// @throws std::invalid_argument if a party of the plan is missing
PartiesByRow parties_by_row(const cases::Plan& plan,
                            std::span<const parties::Party* const> parties);

/// Runs chunks one after the other on one thread and owns that thread's buffers.
class ChunkRunner {
 public:
  /// Both references must outlive the runner.
  ChunkRunner(const cases::Plan& plan, const PartiesByRow& parties, std::size_t max_shown);

  /// Generates the cases of chunk `number` and compares each party of its row with the first.
  ChunkFindings run(std::uint64_t number);

 private:
  struct Answers {
    std::vector<std::uint32_t> out;
    std::vector<parties::Ending> endings;
  };

  /// Compares the answers of the parties to a batch and adds all of them to the digest.
  void compare(const cases::Variant& variant, std::span<const parties::Party* const> parties,
               std::size_t cases);

  const cases::Plan& plan_;
  const PartiesByRow& parties_;
  std::size_t max_shown_;
  std::vector<std::uint32_t> in_;
  Answers judged_;
  Answers other_;
  /// For each case, whether any party differs from the judged one.
  std::vector<std::uint8_t> differs_;
  AnswerDigest digest_;
};

}  // namespace fixproof::verify
