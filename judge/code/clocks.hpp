/// @file
/// The clocks of a user's routine on the processors whose clocks Intel's tables give.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "judge/code/listing.hpp"
#include "judge/code/runner.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::judge {

/// The least, mean and most of a number over several calls. A table with a range gives two means.
class Spread {
 public:
  void add(x86model::Range one);
  [[nodiscard]] std::uint64_t least() const { return least_; }
  [[nodiscard]] std::uint64_t most() const { return most_; }
  [[nodiscard]] double mean_min() const { return mean(sum_.min); }
  [[nodiscard]] double mean_max() const { return mean(sum_.max); }

 private:
  [[nodiscard]] double mean(std::uint64_t sum) const {
    return calls_ == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(calls_);
  }

  std::uint64_t calls_ = 0;
  std::uint64_t least_ = 0;
  std::uint64_t most_ = 0;
  x86model::Range sum_;
};

/// What the calls of a routine take, from its first instruction to its return, without the caller's
/// CALL.
struct RoutineClocks {
  struct OnCpu {
    x86model::Cpu cpu = x86model::Cpu::i8088;
    Spread clocks;
    /// Instructions that ran and have no figure, in the order of their addresses. If there are any,
    /// `clocks` is empty.
    std::vector<Line> without{};
    bool is_too_wide = false;  ///< whether one of them needs a 386
  };
  std::uint64_t calls = 0;  ///< only those that returned
  Spread instructions;
  Spread code_bytes;  ///< of the executed instructions
  Spread data_bytes;  ///< read and written, including those of the stack
  std::array<OnCpu, x86model::cpu_count> on{};
};

/// Counts the calls that inspect() looks at. Needs Unicorn and ndisasm.
/// @throws support::UsageError if ndisasm cannot be run
/// @throws support::Stopped if the user interrupts
RoutineClocks count_clocks(const Subject& subject);

}  // namespace fixproof::judge
