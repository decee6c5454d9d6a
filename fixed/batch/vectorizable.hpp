/// @file
/// Operations on one number in forms that compilers vectorise, for loops that do more than one
/// batch of fixed/batch/batch.hpp. Outside loops, the operators are faster.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

#include "fixed/detail/bits.hpp"
#include "fixed/detail/divide.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/detail/quotient.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"
#include "fixed/traits.hpp"

namespace fixproof::detail {

/// Whether the conversion of numbers in range is rounded_ulps().
template <class Number>
inline constexpr bool has_vector_conversion =
    hardware_double&& std::is_signed_v<typename Number::raw_type>&&
            bits_of<typename Number::raw_type> <= 32 &&
    Number::rules.multiply == rounding::half_up;

/// x in ulps, rounded half up, if that is below 2^49 in magnitude. Larger x, infinities and NaN
/// give a word of at least 2^48 in magnitude.
template <class Number, binary_float Float>
std::int64_t rounded_ulps(Float x) noexcept {
  constexpr int half_ulp = Number::fraction_bits + 1;
  const std::uint64_t placed = placed_floor<1, half_ulp>(static_cast<double>(x));
  return static_cast<std::int64_t>(placed - place_of_floors<half_ulp>) >> 1;
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
      // The low bits of floor(half ulps) + 1, halved.
      const std::uint64_t placed =
          detail::placed_floor<1, Number::fraction_bits + 1>(static_cast<double>(x));
      return Number::from_raw(static_cast<typename Number::raw_type>(placed >> 1));
    }
  }
  return Number(x);
}

}  // namespace fixproof
