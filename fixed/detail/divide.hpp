/// \file
/// Division under a policy: the quotient and the error conditions.
#pragma once

#include <cstdint>
#include <limits>

#include "fixed/detail/overflow.hpp"
#include "fixed/detail/quotient.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The outcome of a division.
enum class division { done, divide_error, out_of_range };

/// The part of the divisor that the policy uses.
template <int FractionBits, policy P>
constexpr std::int32_t effective_divisor(raw_t<FractionBits> d) noexcept {
  if constexpr (P.divisor == divisor_width::whole_part) {
    // Toward zero; the magnitude of the lowest value is unsigned.
    return static_cast<std::int32_t>(
        shift_right<rounding::truncate>(std::int64_t{d}, FractionBits));
  } else {
    return d;
  }
}

/// The shift of the numerator before it is divided by the effective divisor.
template <int FractionBits, policy P>
inline constexpr int numerator_shift = P.divisor == divisor_width::full ? FractionBits : 0;

/// The value of n / 0 if it is not an error: the end of the range with the sign of n, which is the
/// limit for a divisor that falls to zero; 0 / 0 is 0.
constexpr std::int32_t limit_toward_zero(std::int32_t n, std::int32_t highest) noexcept {
  const std::int32_t end = (n >> 31) ^ highest;
  return n == 0 ? 0 : end;
}

/// n / d, wrapped or saturated, without error checks.
template <int FractionBits, policy P>
constexpr raw_t<FractionBits> total_divide(raw_t<FractionBits> n, raw_t<FractionBits> d) noexcept {
  using raw = raw_t<FractionBits>;
  constexpr int shift = numerator_shift<FractionBits, P>;
  const std::int32_t divisor = effective_divisor<FractionBits, P>(d);
  // Divides by 1 instead of 0 and selects by a mask, because a branch would prevent vectorisation.
  const std::int32_t by_zero = -std::int32_t{divisor == 0};
  const std::int32_t limit = limit_toward_zero(n, (std::numeric_limits<raw>::max)());
  std::int32_t quotient = 0;
  if constexpr (P.range == overflow::saturate) {
    quotient = saturated_quotient<raw, P.divide, shift>(n, divisor - by_zero);
  } else {
    quotient = static_cast<std::int32_t>(rounded_quotient<P.divide, shift>(n, divisor - by_zero));
  }
  return static_cast<raw>((quotient & ~by_zero) | (limit & by_zero));
}

/// Whether |n| 2^shift / |divisor| >= 2^(2 FractionBits), without dividing.
template <int FractionBits, policy P>
constexpr bool exceeds_unsigned(raw_t<FractionBits> n, std::int32_t divisor) noexcept {
  const std::int64_t numerator = n < 0 ? -std::int64_t{n} : std::int64_t{n};
  const std::int64_t magnitude = divisor < 0 ? -std::int64_t{divisor} : std::int64_t{divisor};
  return numerator >= magnitude << (2 * FractionBits - numerator_shift<FractionBits, P>);
}

/// The outcome of a division under the policy.
/// \param divisor  the effective one, not zero
/// \param quotient rounded, before wrapping or saturation
template <int FractionBits, policy P>
constexpr division ending_of(raw_t<FractionBits> n, std::int32_t divisor,
                             std::int64_t quotient) noexcept {
  using raw = raw_t<FractionBits>;
  if constexpr (P.fault == divide_fault::unsigned_quotient) {
    if (exceeds_unsigned<FractionBits, P>(n, divisor)) return division::divide_error;
  }
  if constexpr (P.fault == divide_fault::signed_quotient) {
    if (!fits<raw>(quotient)) return division::divide_error;
  }
  if constexpr (P.range == overflow::trap) {
    if (!fits<raw>(quotient)) return division::out_of_range;
  }
  return division::done;
}

/// The outcome of n / d under the policy.
template <int FractionBits, policy P>
constexpr division try_division(raw_t<FractionBits> n, raw_t<FractionBits> d) noexcept {
  constexpr int shift = numerator_shift<FractionBits, P>;
  const std::int32_t divisor = effective_divisor<FractionBits, P>(d);
  if (divisor == 0) return division::divide_error;
  return ending_of<FractionBits, P>(n, divisor, rounded_quotient<P.divide, shift>(n, divisor));
}

}  // namespace fixproof::detail
