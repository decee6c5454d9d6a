/// @file
/// The integer arithmetic of the rounding rules; nothing else implements them.
#pragma once

#include <compare>
#include <cstdint>
#include <type_traits>

#include "fixed/detail/gpu.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// Whether rule Rounding rounds to nearest.
template <rounding Rounding>
inline constexpr bool is_to_nearest =
    Rounding == rounding::half_up || Rounding == rounding::half_away ||
    Rounding == rounding::half_even || Rounding == rounding::nearest;

template <class Int>
constexpr bool is_odd(const Int& x) noexcept {
  return (static_cast<std::uint64_t>(x) & 1) != 0;
}

/// The same, but the compiler does not see that it is a sign. In code for NVIDIA's GPUs, clang++
/// before 19 translates `x >> 63 & 65535` to the bits of x from the 63rd on, which are one.
FIXED_ALWAYS_INLINE constexpr bool hidden(bool negative) noexcept {
#if defined(FIXED_GPU) && defined(__clang__) && __clang_major__ < 19
  if (!std::is_constant_evaluated()) {
    int word{negative};
    asm("" : "+r"(word));
    return word != 0;
  }
#endif
  return negative;
}

/// The bias to add before a floor division by `unit`, so that the quotient is rounded by rule
/// Rounding.
/// @param negative whether the value is below zero
/// @param odd      whether the floor of value / unit is odd; only half_even uses it
/// @param unit     even and positive, so that a half is a whole number of parts
template <rounding Rounding, class Int>
FIXED_ALWAYS_INLINE constexpr Int bias(bool negative, bool odd, Int unit) noexcept {
  if constexpr (Rounding == rounding::half_up) {
    return unit >> 1;
  } else if constexpr (Rounding == rounding::half_away) {
    return (unit >> 1) - Int{negative};
  } else if constexpr (Rounding == rounding::half_even) {
    return (unit >> 1) - Int{!odd};
  } else if constexpr (Rounding == rounding::truncate) {
    return hidden(negative) ? unit - Int{1} : Int{0};
  } else if constexpr (Rounding == rounding::ceiling) {
    return unit - Int{1};
  } else {
    static_assert(Rounding == rounding::floor);
    return Int{0};
  }
}

/// value / 2^bits, rounded by rule Rounding. @pre Int is signed, and value + 2^bits does not
/// overflow
template <rounding Rounding, class Int>
FIXED_ALWAYS_INLINE constexpr Int shift_right(Int value, int bits) noexcept {
  if (bits == 0) return value;
  const bool odd = Rounding == rounding::half_even && is_odd(value >> bits);
  return (value + bias<Rounding>(value < Int{0}, odd, Int{1} << bits)) >> bits;
}

/// Whether a result between two integers is rounded to the upper one.
/// @param order    the distance to the lower one against the distance to the upper one
/// @param exact    whether the distance to the lower one is zero
/// @param odd      whether the lower one is odd
template <rounding Rounding>
constexpr bool rounds_up(std::strong_ordering order, bool exact, bool negative, bool odd) noexcept {
  if constexpr (Rounding == rounding::half_up) {
    return std::is_gteq(order);
  } else if constexpr (Rounding == rounding::half_away) {
    return std::is_gt(order) || (std::is_eq(order) && !negative);
  } else if constexpr (Rounding == rounding::half_even) {
    return std::is_gt(order) || (std::is_eq(order) && odd);
  } else if constexpr (Rounding == rounding::truncate) {
    return negative && !exact;
  } else if constexpr (Rounding == rounding::ceiling) {
    return !exact;
  } else {
    static_assert(Rounding == rounding::floor);
    return false;
  }
}

/// numerator / divisor toward -infinity, for a positive divisor.
template <class Int>
constexpr Int floor_divide(Int numerator, Int divisor) noexcept {
  return numerator / divisor - Int{numerator % divisor < 0};
}

/// The quotient of magnitudes, rounded down. @pre numerator >= 0, divisor > 0, a bit to spare
template <class Int>
constexpr Int truncated_ratio(const Int& numerator, const Int& divisor) noexcept {
  if constexpr (is_built_in<Int>) {
    return numerator / divisor;
  } else {
    return Int::divide(numerator, divisor).quotient;
  }
}

/// numerator / divisor rounded by rule Rounding. @pre the divisor is not zero; both have a bit to
/// spare
template <rounding Rounding, class Int>
constexpr Int rounded_ratio(Int numerator, Int divisor) noexcept {
  const Int zero{0};
  if (divisor < zero) {
    numerator = -numerator;
    divisor = -divisor;
  }
  const bool negative = numerator < zero;
  Int floor{};
  Int above_floor{};
  if constexpr (is_built_in<Int>) {
    floor = numerator / divisor;
    above_floor = numerator % divisor;
  } else {
    const auto parts = Int::divide(negative ? -numerator : numerator, divisor);
    floor = negative ? -parts.quotient : parts.quotient;
    above_floor = negative ? -parts.remainder : parts.remainder;
  }
  if (above_floor < zero) {
    floor = floor - Int{1};
    above_floor = above_floor + divisor;
  }
  const Int to_upper = divisor - above_floor;
  const std::strong_ordering order = ordering(above_floor < to_upper, to_upper < above_floor);
  return floor + Int{rounds_up<Rounding>(order, above_floor == zero, negative, is_odd(floor))};
}

/// Whether the magnitude of a quotient grows by one, when rule Rounding rounds it.
/// @param rest the remainder of the magnitudes, below their divisor
/// @param odd  whether the quotient of the magnitudes is odd; only half_even uses it
template <rounding Rounding, class Word>
constexpr bool grows(Word rest, Word divisor, bool negative, bool odd) noexcept {
  const Word to_next = divisor - rest;
  if constexpr (Rounding == rounding::half_up) {
    return rest + Word{!negative} > to_next;
  } else if constexpr (Rounding == rounding::half_away) {
    return rest >= to_next;
  } else if constexpr (Rounding == rounding::half_even) {
    return rest + Word{odd} > to_next;
  } else if constexpr (Rounding == rounding::truncate) {
    return false;
  } else if constexpr (Rounding == rounding::ceiling) {
    return !negative && rest != 0;
  } else {
    static_assert(Rounding == rounding::floor);
    return negative && rest != 0;
  }
}

/// -x modulo 2^(bits of Word) if `negative`, else x, without a branch.
template <class Word>
constexpr Word negated_if(bool negative, Word x) noexcept {
  const Word mask = Word{0} - Word{negative};
  return (x ^ mask) - mask;
}

/// rounded_ratio() with one division and without a branch, if Int has at most 64 bits.
///
/// It divides magnitudes. Random signs and remainders make branches hard to predict, and clang++
/// branches between the objects of std::strong_ordering.
/// @pre the divisor is not zero, and the result fits; a wider Int has a bit to spare
template <rounding Rounding, class Int>
constexpr Int quick_ratio(Int numerator, Int divisor) noexcept {
  if constexpr (sizeof(Int) <= sizeof(std::uint64_t)) {
    using word = std::make_unsigned_t<Int>;
    const bool divisor_below = divisor < 0;
    const bool negative = (numerator < 0) != divisor_below;
    const word n = negated_if(numerator < 0, static_cast<word>(numerator));
    const word d = negated_if(divisor_below, static_cast<word>(divisor));
    const word floor = n / d;
    const word nearest = floor + word{grows<Rounding>(n % d, d, negative, is_odd(floor))};
    return static_cast<Int>(negated_if(negative, nearest));
  } else {
    return rounded_ratio<Rounding>(numerator, divisor);
  }
}

}  // namespace fixproof::detail
