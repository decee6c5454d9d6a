/// @file
/// The clocks per call of a routine on each processor that can run it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "measure/clocks/bounds.hpp"
#include "measure/measure.hpp"
#include "verify/cases/variant.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::measure {

/// The least, mean and greatest of a count that is a range in every call.
class Spread {
 public:
  /// Extends the range without adding the call to the mean.
  void bound(x86model::Range r) {
    least_ = std::min(least_, r.min);
    most_ = std::max(most_, r.max);
  }
  void add(x86model::Range r) {
    bound(r);
    sum_ += r;
    ++calls_;
  }

  /// Precondition: there is at least one call.
  [[nodiscard]] std::uint64_t least() const { return least_; }
  [[nodiscard]] std::uint64_t most() const { return most_; }
  /// The number of calls in the mean.
  [[nodiscard]] std::uint64_t calls() const { return calls_; }
  /// The bounds of the mean, equal if every count was exact; 0 without calls.
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

struct ProcessorClocks {
  x86model::Cpu cpu{};
  Spread clocks{};              ///< by Intel's table
  std::optional<Spread> bus{};  ///< on an 8088; see x86model/bus.hpp

  [[nodiscard]] Clocks mean() const {
    return {{clocks.mean_min(), clocks.mean_max()}, bus ? bus->mean_min() : 0};
  }
};

/// The clocks of one routine. A divide error only counts as such.
struct CallClocks {
  cases::Variant variant;
  Spread instructions{};
  std::vector<ProcessorClocks> processors{};
  std::uint64_t faults = 0;
};

/// The processors that can run the variant's program.
std::span<const x86model::Cpu> processors_of(const cases::Variant& variant);

/// The distinct builds of the printed listings. CosSin has no rounding switch, so each target has
/// one build of it.
std::vector<cases::Variant> timed_variants();

/// Counts of a variant before the first call.
CallClocks no_calls(const cases::Variant& variant);

/// Adds calls with the operands of `words`, case by case.
/// @param typical whether the mean includes them
/// @param stop    ends the run early
void add_calls(CallClocks& clocks, std::span<const std::uint32_t> words, bool typical,
               const std::atomic<bool>& stop = never_stop);

/// Adds calls with the cases of a verification at level 1: the whole boundary lattice, and at most
/// `cases` of every other stream.
void add_cases(CallClocks& clocks, std::uint64_t seed, std::uint64_t cases, bool typical,
               const std::atomic<bool>& stop);

}  // namespace fixproof::measure
