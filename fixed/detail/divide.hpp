/// \file
/// Division by policy: which quotient, and whether there is one.
#pragma once

#include <cstdint>
#include <limits>

#include "fixed/detail/overflow.hpp"
#include "fixed/detail/quotient.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixed::detail {

/// How a division ended.
enum class division { done, divide_error, out_of_range };

/// The part of the divisor the policy looks at.
template <int FractionBits, policy P>
constexpr std::int32_t effective_divisor(raw_t<FractionBits> d) noexcept {
  if constexpr (P.divisor == divisor_width::whole_part) {
    // Toward zero; the magnitude of the lowest value counts as unsigned.
    return static_cast<std::int32_t>(
        shift_right<rounding::truncate>(std::int64_t{d}, FractionBits));
  } else {
    return d;
  }
}

/// What the numerator is shifted by before it is divided by the effective divisor.
template <int FractionBits, policy P>
inline constexpr int numerator_shift = P.divisor == divisor_width::full ? FractionBits : 0;

/// What stands for n / 0 where that is no error: the limit of the quotient for a divisor that falls
/// to zero, that is the end of the range on the numerator's side; 0 / 0 is 0.
template <class Raw>
constexpr Raw limit_toward_zero(Raw n) noexcept {
  constexpr Raw lowest = std::numeric_limits<Raw>::min();
  constexpr Raw highest = std::numeric_limits<Raw>::max();
  return n > 0 ? highest : n < 0 ? lowest : Raw{0};
}

/// n / d for operands whose division is done: wrapped or saturated, never an error.
template <int FractionBits, policy P>
constexpr raw_t<FractionBits> total_divide(raw_t<FractionBits> n, raw_t<FractionBits> d) noexcept {
  using raw = raw_t<FractionBits>;
  constexpr int shift = numerator_shift<FractionBits, P>;
  const std::int32_t divisor = effective_divisor<FractionBits, P>(d);
  // Divided by 1 instead of 0, and chosen afterwards: no branch, so that loops are vectorised.
  const std::int32_t nonzero = divisor == 0 ? 1 : divisor;
  raw result{};
  if constexpr (P.range == overflow::saturate) {
    result = saturated_quotient<raw, P.divide, shift>(n, nonzero);
  } else {
    result = static_cast<raw>(rounded_quotient<P.divide, shift>(n, nonzero));
  }
  return divisor == 0 ? limit_toward_zero(n) : result;
}

/// How n / d ends under the policy.
template <int FractionBits, policy P>
constexpr division try_division(raw_t<FractionBits> n, raw_t<FractionBits> d) noexcept {
  using raw = raw_t<FractionBits>;
  constexpr int shift = numerator_shift<FractionBits, P>;
  const std::int32_t divisor = effective_divisor<FractionBits, P>(d);
  if (divisor == 0) return division::divide_error;
  if constexpr (P.fault == divide_fault::unsigned_quotient) {
    constexpr std::int64_t limit = std::int64_t{1} << (2 * FractionBits);
    const auto truncated = rounded_quotient<rounding::truncate, shift>(n, divisor);
    if (truncated >= limit || truncated <= -limit) return division::divide_error;
  }
  if constexpr (P.fault == divide_fault::signed_quotient) {
    if (!fits<raw>(rounded_quotient<P.divide, shift>(n, divisor))) return division::divide_error;
  }
  if constexpr (P.range == overflow::trap) {
    if (!fits<raw>(rounded_quotient<P.divide, shift>(n, divisor))) return division::out_of_range;
  }
  return division::done;
}

}  // namespace fixed::detail
