/// @file
/// Operations on one number in forms that compilers vectorise, for loops that do more than one
/// batch of fixed/batch/batch.hpp. Outside loops, the operators are faster.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "fixed/detail/bit_cast.hpp"
#include "fixed/detail/bits.hpp"
#include "fixed/detail/divide.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"
#include "fixed/traits.hpp"

namespace fixproof::detail {

/// Whether the conversion of numbers in range is rounded_half_up() of their ulps.
template <class Number>
inline constexpr bool has_vector_conversion =
    hardware_double&& std::is_signed_v<typename Number::raw_type>&&
            bits_of<typename Number::raw_type> <= 32 &&
    Number::rules.multiply == rounding::half_up;

/// floor(x + 1/2) for |x| < 2^50, and a word of at least 2^49 in magnitude for others and for NaN.
/// In every rounding mode of the processor, without a branch and without a 64-bit conversion, which
/// SSE2 has only for scalars.
///
/// Adding 1.5 * 2^52 to an integer below 2^51 gives a double whose low bits are that integer. To
/// another number, it adds an integer next to it. The bits of doubles rise with the doubles, so
/// other sums are as far from the constant.
inline std::int64_t rounded_half_up(double x) noexcept {
  constexpr double ones = 0x1.8p52;
  constexpr auto bits_of_ones = bit_cast<std::uint64_t>(ones);
#if defined(__clang__) && (defined(__SSE4_1__) || defined(__aarch64__))
  // g++ 12 vectorises no floor.
  const auto twice = bit_cast<std::uint64_t>(__builtin_floor(x + x) + ones) - bits_of_ones;
  return static_cast<std::int64_t>(twice + 1) >> 1;
#else
  // What x is above the integer is exact: less than one, and a multiple of the last place of x. In
  // the nearest mode it is at most a half on either side.
  const double placed = x + ones;
  const double above = x - (placed - ones);
  return static_cast<std::int64_t>(bit_cast<std::uint64_t>(placed) - bits_of_ones +
                                   std::uint64_t{above >= 0.5} - std::uint64_t{above < -0.5});
#endif
}

/// The ulps of a float or double, which are exact unless they are beyond every number.
template <class Number, binary_float Float>
std::int64_t rounded_ulps(Float x) noexcept {
  constexpr double one = std::int64_t{1} << Number::fraction_bits;
  return rounded_half_up(static_cast<double>(x) * one);
}

}  // namespace fixproof::detail

namespace fixproof {

/// n / d, with the same result for all operands. In 16.16 and other signed formats of up to 32 bits
/// with up to 16 after the point, it divides doubles, of which vector registers divide several at
/// once. operator/ divides 64-bit integers, one at a time, because a result that waits for another
/// one is there sooner.
///
///     static_assert(vectorizable_divide(q16_16(1), q16_16(3)) == q16_16(1) / q16_16(3));
template <any_number Number>
[[nodiscard]] constexpr Number vectorizable_divide(Number n,
                                                   Number d) noexcept(Number::divide_never_throws) {
  if constexpr (Number::divide_never_throws) {
    return Number::from_raw(
        detail::total_divide<typename Number::raw_type, Number::fraction_bits, Number::rules>(
            n.raw(), d.raw()));
  } else {
    return n / d;
  }
}

/// Number(x), for results in range: others, infinities and NaN give an unspecified number. Tests
/// nothing, in signed formats of up to 32 bits that round halves up.
///
///     std::vector<double> samples{0.25, -1.5};
///     std::vector<q16_16> words(2);
///     for (std::size_t i = 0; i < 2; ++i) words[i] = vectorizable_from<q16_16>(samples[i]);
template <any_number Number, detail::binary_float Float>
[[nodiscard]] constexpr Number vectorizable_from(Float x) noexcept(Number::never_throws) {
  if constexpr (detail::has_vector_conversion<Number>) {
    if (!std::is_constant_evaluated()) {
      return Number::from_raw(
          static_cast<typename Number::raw_type>(detail::rounded_ulps<Number>(x)));
    }
  }
  return Number(x);
}

}  // namespace fixproof
