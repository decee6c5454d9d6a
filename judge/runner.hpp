/// @file
/// Runs a user's routine for many cases, in a process of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/confined.hpp"
#include "judge/machine.hpp"

namespace fixproof::judge {

/// A routine, how to call it, and what it should compute. It must outlive everything that works on
/// it.
struct Subject {
  Image image;
  Frame frame;
  cases::Variant variant;
};

/// The outcome of one call.
struct Answer {
  Ending ending{};
  std::uint16_t broken = 0;                                 ///< see Call::broken()
  std::uint16_t changed = 0;                                ///< see Call::changed()
  std::array<std::uint32_t, cases::max_words_out> words{};  ///< valid if it returned
};

/// Tells whether a call returned or raised #DE.
bool ended_well(const Answer& answer);

enum class On { processor, unicorn };

/// Answers cases on one machine.
class Runner {
 public:
  Runner(const Subject& subject, On machine);

  /// Answers the cases in `words`, words_in(variant) words each. Stops after a case that neither
  /// returns nor raises #DE. If the process dies at a case, that case gets End::fault, or
  /// End::endless if it took too long.
  /// @throws proof::Stopped; std::system_error if the system provides no process
  std::vector<Answer> answers(std::span<const std::uint32_t> words);
  /// Returns why the process last died, or Downfall::none if it never did.
  [[nodiscard]] Downfall downfall() const { return downfall_; }

 private:
  Reply ask(std::span<const std::uint32_t> words);

  const Subject& subject_;
  On machine_;
  std::unique_ptr<Confined> child_;
  Downfall downfall_ = Downfall::none;
};

/// A call, step by step.
struct TracedCall {
  Answer answer;
  Trace trace;
};

/// Traces one call on Unicorn. Returns nothing if its process dies, which only a defect of Unicorn
/// can cause.
/// @throws proof::Stopped
std::optional<TracedCall> traced(const Subject& subject, std::span<const std::uint32_t> words);

}  // namespace fixproof::judge
