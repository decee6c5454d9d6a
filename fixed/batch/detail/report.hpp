/// @file
/// The report of a batch, and its collection.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "fixed/batch/detail/element.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/error.hpp"
#include "fixed/policy.hpp"

namespace fixproof::batch {

/// How many elements or vertices have which fault, and where the first one is. An element counts
/// once, for the first fault of its calculation.
struct report {
  /// The value of `first` if there is no fault.
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

  /// Quotients for which fixproof::try_divide returns nothing, except plain overflows: zero
  /// divisors and other errors under policy::fault.
  std::size_t divide_errors = 0;
  /// Results out of range: saturated under overflow::saturate, wrapped under overflow::trap. Under
  /// overflow::wrap, only the square roots, which saturate.
  std::size_t overflows = 0;
  /// Square roots of negative numbers, and conversions of NaN.
  std::size_t domain_errors = 0;
  /// The index of the first element with a fault.
  std::size_t first = nowhere;

  /// Whether there is no fault.
  [[nodiscard]] constexpr bool clean() const noexcept { return first == nowhere; }
  /// Whether all members are equal.
  friend constexpr bool operator==(const report&, const report&) = default;
};

}  // namespace fixproof::batch

namespace fixproof::detail {

/// The number of faults of one kind in a batch; an operand of raise().
struct fault_count {
  std::size_t count;
  std::size_t first;
};

inline std::string describe(const fault_count& x) {
  return "element " + std::to_string(x.first) + ", " + std::to_string(x.count) + " in all";
}

/// Collects the faults of one batch. Most batches have none, so a recorder costs next to nothing
/// until the first fault.
class fault_recorder {
 public:
  /// @param marks one for each element, or none
  explicit fault_recorder(std::span<bool> marks) noexcept : marks_(marks) {
    if (!marks.empty()) std::fill(marks.begin(), marks.end(), false);
  }

  void note(fault what, std::size_t index) noexcept {
    if (what != fault::none) note_bits(what, 1, index);
  }

  /// Records a fault of element index + k for every bit k that is set in `bits`.
  /// @param bits must not be zero
  void note_bits(fault what, std::uint32_t bits, std::size_t index) noexcept {
    if (!any_) found_.fill({0, batch::report::nowhere});
    any_ = true;
    fault_count& found = found_[static_cast<std::size_t>(what)];
    found.count += static_cast<std::size_t>(std::popcount(bits));
    found.first = (std::min)(found.first, index + static_cast<std::size_t>(std::countr_zero(bits)));
    if (marks_.empty()) return;
    for (; bits != 0; bits &= bits - 1) {
      marks_[index + static_cast<std::size_t>(std::countr_zero(bits))] = true;
    }
  }

  /// Returns the report. Without marks, throws the error of the first element for which an
  /// operation under these rules throws.
  /// @param operation the name in the text of the error
  template <overflow Overflow, divide_fault Fault>
  [[nodiscard]] batch::report finish(const char* operation) const {
    if (!any_) [[likely]] {
      return {};
    }
    return finish_with_faults<Overflow, Fault>(operation);
  }

 private:
  template <overflow Overflow, divide_fault Fault>
  [[nodiscard]] FIXED_NOINLINE batch::report finish_with_faults(const char* operation) const {
    const fault_count& divides = of(fault::divide_error);
    const fault_count& ranges = of(fault::overflow);
    const fault_count& domains = of(fault::domain_error);
    constexpr bool traps = Overflow == overflow::trap;
    if constexpr (traps || Fault != divide_fault::none) {
      const bool before = !traps || divides.first < ranges.first;
      if (marks_.empty() && divides.count > 0 && before) {
        raise<divide_error>("divide error", operation, divides);
      }
    }
    if constexpr (traps) {
      if (marks_.empty() && ranges.count > 0 && ranges.first < domains.first) {
        raise<overflow_error>("overflow", operation, ranges);
      }
      if (marks_.empty() && domains.count > 0) {
        raise<domain_error>("domain error", operation, domains);
      }
    }
    return {divides.count, ranges.count, domains.count,
            (std::min)({divides.first, ranges.first, domains.first})};
  }

  [[nodiscard]] const fault_count& of(fault what) const {
    return found_[static_cast<std::size_t>(what)];
  }

  bool any_ = false;
  std::array<fault_count, 4> found_{};  ///< meaningless unless any_
  std::span<bool> marks_;
};

/// Asks run() to compute a span of at most one register, without a call.
struct few_blocks {};

/// Asks run() to compute a span of any length without a call, because the loop is short.
struct all_blocks {};

/// How many elements are done already, and what records the faults of the others.
struct recording {
  std::size_t done;
  fault_recorder& found;
};

}  // namespace fixproof::detail
