/// @file
/// The clocks of a user's routine on the processors that have a table.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "judge/listing.hpp"
#include "judge/runner.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::judge {

/// A number per call over several calls; two numbers where a table has a range.
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

/// From the first instruction of the routine to its return, without the caller's CALL.
struct RoutineClocks {
  struct OnCpu {
    x86model::Cpu cpu = x86model::Cpu::i8088;
    Spread clocks;
    /// Instructions that ran and have no figure, in the order of their addresses: then `clocks` is
    /// empty.
    std::vector<Line> without{};
    bool is_too_wide = false;  ///< one of them is for a 386
  };
  std::uint64_t calls = 0;  ///< that returned
  Spread instructions;
  Spread code_bytes;  ///< of the executed instructions
  Spread data_bytes;  ///< read and written, the stack too
  std::array<OnCpu, x86model::cpu_count> on{};
};

/// Counts over the calls that inspect() looks at. Needs Unicorn and ndisasm.
/// @throws support::UsageError if ndisasm cannot be run; proof::Stopped
RoutineClocks count_clocks(const Subject& subject);

}  // namespace fixproof::judge
