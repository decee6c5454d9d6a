/// @file
/// What a call of a routine takes on each processor that can run it, over many operands.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "cases/variant.hpp"
#include "measure/clocks/bounds.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::measure {

/// Least, mean and most of a count that is known within bounds in every call.
class Spread {
 public:
  /// A call that may be the least or the most, but is none of those whose mean is wanted.
  void bound(x86model::Range r) {
    least_ = std::min(least_, r.min);
    most_ = std::max(most_, r.max);
  }
  void add(x86model::Range r) {
    bound(r);
    sum_ += r;
    ++calls_;
  }

  /// Of all calls; there must have been one.
  [[nodiscard]] std::uint64_t least() const { return least_; }
  [[nodiscard]] std::uint64_t most() const { return most_; }
  /// How many calls the mean is of.
  [[nodiscard]] std::uint64_t calls() const { return calls_; }
  /// Bounds of the mean, the same where every count was exact; 0 where it is of no calls.
  [[nodiscard]] double mean_min() const { return mean(sum_.min); }
  [[nodiscard]] double mean_max() const { return mean(sum_.max); }

 private:
  [[nodiscard]] double mean(std::uint64_t sum) const {
    return calls_ == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(calls_);
  }

  std::uint64_t least_ = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t most_ = 0;
  x86model::Range sum_;
  std::uint64_t calls_ = 0;
};

/// On one processor.
struct ProcessorClocks {
  x86model::Cpu cpu{};
  Spread clocks{};              ///< by Intel's table
  std::optional<Spread> bus{};  ///< of an 8088; see x86model/bus.hpp

  [[nodiscard]] Clocks mean() const {
    return {{clocks.mean_min(), clocks.mean_max()}, bus ? bus->mean_min() : 0};
  }
};

/// Of one routine. A call that ends in a divide error is counted as that alone.
struct CallClocks {
  cases::Variant variant;
  Spread instructions{};
  std::vector<ProcessorClocks> processors{};
  std::uint64_t faults = 0;
};

/// Those that can run the program of the variant.
std::span<const x86model::Cpu> processors_of(const cases::Variant& variant);

/// The builds of the printed listings that differ: CosSin, which has no switch, once for each
/// target.
std::vector<cases::Variant> timed_variants();

/// Nothing counted yet.
CallClocks no_calls(const cases::Variant& variant);

/// Adds calls with the operands of `words`, one case after the other.
/// @param typical whether they are to be part of the mean
/// @param stop    ends the run before its time
void add_calls(CallClocks& clocks, std::span<const std::uint32_t> words, bool typical,
               const std::atomic<bool>& stop);

/// Adds calls with the cases of a verification at level 1: the boundary lattice whole, and of
/// every other stream at most `cases`.
void add_cases(CallClocks& clocks, std::uint64_t seed, std::uint64_t cases, bool typical,
               const std::atomic<bool>& stop);

}  // namespace fixproof::measure
