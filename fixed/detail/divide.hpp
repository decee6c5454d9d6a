/// @file
/// Division under a policy: the quotient and the error conditions.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/inlining.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/quotient.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The outcome of a division.
enum class division { done, divide_error, out_of_range };

/// Holds every divisor.
template <class Raw>
using divisor_t = signed_t<signed_bits<Raw>>;

/// The part of the divisor that the policy uses.
template <class Raw, int FractionBits, policy Rules>
FIXED_ALWAYS_INLINE constexpr divisor_t<Raw> effective_divisor(Raw d) noexcept {
  if constexpr (Rules.divisor == divisor_width::whole_part) {
    // Toward zero; the magnitude of the lowest value is unsigned.
    using wide = signed_t<signed_bits<Raw> + 1>;
    return static_cast<divisor_t<Raw>>(shift_right<rounding::truncate>(wide{d}, FractionBits));
  } else {
    return divisor_t<Raw>{d};
  }
}

/// The shift of the numerator before it is divided by the effective divisor.
template <int FractionBits, policy Rules>
inline constexpr int numerator_shift = Rules.divisor == divisor_width::full ? FractionBits : 0;

/// The value of n / 0 if it is not an error: the end of the range with the sign of n, which is the
/// limit for a divisor that falls to zero; 0 / 0 is 0.
template <class Raw>
constexpr Raw limit_toward_zero(Raw n) noexcept {
  // The sign bit in every place for a signed Raw, and 0 for an unsigned one.
  const auto sign = static_cast<Raw>(n >> std::numeric_limits<Raw>::digits % bits_of<Raw>);
  const Raw highest = (std::numeric_limits<Raw>::max)();
  const auto end = std::is_signed_v<Raw> ? static_cast<Raw>(sign ^ highest) : highest;
  return n == 0 ? Raw{0} : end;
}

/// The same for a signed integer, in the form that the compiler vectorises best.
template <class Raw>
constexpr std::int32_t vectorizable_limit(Raw n) noexcept {
  constexpr std::int32_t highest = (std::numeric_limits<Raw>::max)();
  const std::int32_t wide = n;
#if defined(__clang__)
  const auto negated = static_cast<std::int32_t>(0 - static_cast<std::uint32_t>(wide));
  return ((negated & ~wide) >> 31 & highest) | (wide & ~highest);
#else
  return (wide >> 31 ^ highest) & -std::int32_t{wide != 0};
#endif
}

/// The same for a numerator of any type.
template <class Raw>
constexpr Raw by_zero(bool negative, bool zero) noexcept {
  using limits = std::numeric_limits<Raw>;
  if (zero) return Raw{0};
  return negative ? (limits::min)() : (limits::max)();
}

/// Whether quotient.hpp has the quotient in integers.
template <class Raw, int FractionBits, policy Rules>
inline constexpr bool has_integer_quotient =
    std::is_signed_v<Raw>&& bits_of<Raw> <= 32 && numerator_shift<FractionBits, Rules> <= 30 &&
    Rules.divide != rounding::half_even;

/// Whether quotient.hpp also has the quotient in doubles, a form that compilers vectorise.
template <class Raw, int FractionBits, policy Rules>
inline constexpr bool has_fast_quotient =
    has_integer_quotient<Raw, FractionBits, Rules>&& numerator_shift<FractionBits, Rules> <= 16 &&
    Rules.divide != rounding::ceiling;

/// Holds a numerator after its shift, and every quotient.
template <class Raw, int FractionBits, policy Rules>
using quotient_t =
    signed_t<larger(64, signed_bits<Raw> + numerator_shift<FractionBits, Rules> + 1)>;

/// The rounded quotient. @param divisor the effective one, not zero
template <class Raw, int FractionBits, policy Rules>
FIXED_ALWAYS_INLINE constexpr quotient_t<Raw, FractionBits, Rules> quotient_of(
    Raw n, divisor_t<Raw> divisor) noexcept {
  constexpr int shift = numerator_shift<FractionBits, Rules>;
  if constexpr (has_fast_quotient<Raw, FractionBits, Rules> && divides_in_double) {
    return rounded_quotient<Rules.divide, shift>(n, divisor);
  } else if constexpr (has_integer_quotient<Raw, FractionBits, Rules>) {
    return integer_quotient<Rules.divide, shift>(n, divisor);
  } else {
    using wide = quotient_t<Raw, FractionBits, Rules>;
    return rounded_ratio<Rules.divide>(wide{n} << shift, static_cast<wide>(divisor));
  }
}

/// n / d, wrapped or saturated, without error checks.
template <class Raw, int FractionBits, policy Rules>
FIXED_ALWAYS_INLINE constexpr Raw divide_unless_zero(Raw n, Raw d) noexcept {
  const divisor_t<Raw> divisor = effective_divisor<Raw, FractionBits, Rules>(d);
  if (divisor == divisor_t<Raw>{0}) return limit_toward_zero(n);
  constexpr overflow range =
      Rules.quotient_range() == overflow::saturate ? overflow::saturate : overflow::wrap;
  return narrow<range, Raw>(quotient_of<Raw, FractionBits, Rules>(n, divisor), [] {});
}

/// divide_unless_zero() in a form that compilers vectorise, if has_fast_quotient.
template <class Raw, int FractionBits, policy Rules>
constexpr Raw total_divide(Raw n, Raw d) noexcept {
  if constexpr (has_fast_quotient<Raw, FractionBits, Rules>) {
    constexpr int shift = numerator_shift<FractionBits, Rules>;
    const divisor_t<Raw> divisor = effective_divisor<Raw, FractionBits, Rules>(d);
    // A mask selects the result, because a branch would prevent vectorisation.
    const std::int32_t by_zero = -std::int32_t{divisor == 0};
    const std::int32_t limit = vectorizable_limit(n);
    std::int32_t quotient = 0;
    if constexpr (Rules.quotient_range() == overflow::saturate) {
      quotient = saturated_quotient<Raw, Rules.divide, shift>(n, divisor);
    } else {
      quotient = wrapped_quotient<Rules.divide, shift>(n, divisor);
    }
    return static_cast<Raw>((quotient & ~by_zero) | (limit & by_zero));
  } else {
    return divide_unless_zero<Raw, FractionBits, Rules>(n, d);
  }
}

/// The same in the form of single quotients.
template <class Raw, int FractionBits, policy Rules>
FIXED_ALWAYS_INLINE constexpr Raw single_divide(Raw n, Raw d) noexcept {
  if constexpr (divides_in_double) {
    return total_divide<Raw, FractionBits, Rules>(n, d);
  } else {
    return divide_unless_zero<Raw, FractionBits, Rules>(n, d);
  }
}

/// Whether |n| 2^shift / |divisor| is at least 2^(bits of Raw), without dividing.
template <class Raw, int FractionBits, policy Rules>
constexpr bool exceeds_unsigned(Raw n, divisor_t<Raw> divisor) noexcept {
  constexpr int shift = bits_of<Raw> - numerator_shift<FractionBits, Rules>;
  using wide = signed_t<larger(64, signed_bits<Raw> + 1 + shift)>;
  const wide numerator{n};
  const auto magnitude = static_cast<wide>(divisor);
  const wide zero{0};
  return !((numerator < zero ? -numerator : numerator) < (magnitude < zero ? -magnitude : magnitude)
                                                             << shift);
}

/// The outcome of a division under the policy.
/// @param divisor  the effective one, not zero
/// @param quotient rounded, before wrapping or saturation
template <class Raw, int FractionBits, policy Rules>
constexpr division ending_of(Raw n, divisor_t<Raw> divisor,
                             const quotient_t<Raw, FractionBits, Rules>& quotient) noexcept {
  if constexpr (Rules.fault == divide_fault::unsigned_quotient) {
    if (exceeds_unsigned<Raw, FractionBits, Rules>(n, divisor)) return division::divide_error;
  }
  if constexpr (Rules.fault == divide_fault::signed_quotient) {
    if (!fits<Raw>(quotient)) return division::divide_error;
  }
  if constexpr (Rules.quotient_range() == overflow::trap) {
    if (!fits<Raw>(quotient)) return division::out_of_range;
  }
  return division::done;
}

/// The outcome of n / d under the policy.
template <class Raw, int FractionBits, policy Rules>
constexpr division try_division(Raw n, Raw d) noexcept {
  const divisor_t<Raw> divisor = effective_divisor<Raw, FractionBits, Rules>(d);
  if (divisor == divisor_t<Raw>{0}) return division::divide_error;
  return ending_of<Raw, FractionBits, Rules>(n, divisor,
                                             quotient_of<Raw, FractionBits, Rules>(n, divisor));
}

}  // namespace fixproof::detail
