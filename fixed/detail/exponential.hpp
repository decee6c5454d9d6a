/// @file
/// Exponentials and logarithms of words of at most 32 bits, each the nearest integer of ulps.
///
/// The code first computes a result in 64 bits, with a bound of its error. If the bound allows two
/// integers, which is rare, it computes the result again with an error below 2^-160. Formats of at
/// most 16 fraction bits first try fewer terms. A tie is rational. Lindemann's theorem and the
/// theorem of Gelfond and Schneider show which results are rational, and the code treats those
/// separately.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/bit_cast.hpp"
#include "fixed/detail/bits.hpp"
#include "fixed/detail/choose.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/gpu.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/precise_exponential.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/series.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

// How many terms of the series careful results take, and how many quick ones take.
inline constexpr std::size_t power_terms = power_coefficients.size();
inline constexpr std::size_t logarithm_terms = logarithm_coefficients.size();
inline constexpr std::size_t quick_power_terms = 5;
inline constexpr std::size_t quick_logarithm_terms = 4;

/// 2^(x / 2^64) in units of 2^-63, at most 15 units too low and never too high.
///
/// The table takes 5 bits of x. The Taylor series of the rest loses at most 2 units in each of
/// eight steps, counted in units of 2^-64, and its remainder is below 2^-68. With five
/// terms the remainder is below 2^-42.6, and the result at most 4194304 units too low.
template <std::size_t Terms>
constexpr std::uint64_t power_of_two(std::uint64_t x) noexcept {
  const std::uint64_t rest = x << 5;
  const std::uint64_t sum = sum_of_series<Terms>(power_coefficients, rest);
  const std::uint64_t power = powers_of_two[static_cast<std::uint32_t>(x >> 59)];
  return power + multiply_high(power, multiply_high(rest, sum));
}

/// An exponent of 2: whole + fraction / 2^64.
struct binary_exponent {
  std::int64_t whole;
  std::uint64_t fraction;
};

/// The exponent of 2 of an exponential of x / 2^32. For base e the error is at most
/// |x| 2^-95 + 2^-64.
template <exponential_base Base>
constexpr binary_exponent exponent_of(std::int64_t x) noexcept {
  if constexpr (Base == exponential_base::two) {
    return {x >> 32, static_cast<std::uint64_t>(x) << 32};
  } else {
    // x modulo 2^64 is 2^64 more than a negative x.
    const two_words product = multiply_words(static_cast<std::uint64_t>(x), log2_e);
    const std::uint64_t high = product.high - chosen(x < 0, log2_e, std::uint64_t{0});
    return {static_cast<std::int64_t>(high) >> 31, high << 33 | product.low >> 31};
  }
}

/// 2^exponent in units of 2^-fraction_bits, to nearest, for an irrational result; 2^35 for every
/// result that is not below 2^34 units.
constexpr std::int64_t nearest_precise_power(const real& exponent, int fraction_bits) noexcept {
  // A logarithm is at most 32, and the exponent of a power below 2^32.
  const auto floor = static_cast<std::int64_t>(exponent >> real_bits);
  FIXED_ASSERT(real{floor} == exponent >> real_bits);
  if (floor >= 34 - fraction_bits) return std::int64_t{1} << 35;
  if (floor < -2 - fraction_bits) return 0;
  const int whole = static_cast<int>(floor);
  const real power = precise_power(exponent - (real{whole} << real_bits));
  return nearest_units(whole < 0 ? power >> -whole : power << whole, fraction_bits);
}

/// The ends of 2^exponent in units of 2^-fraction_bits; any integers from 2^33 on for a result that
/// is not below 2^34 units. @param error of the exponent, in units of 2^-64, below 2^54
template <std::size_t Terms>
constexpr nearest_ends power_within(const binary_exponent& exponent, std::int64_t error,
                                    int fraction_bits) noexcept {
  // Without a branch, because operands of all sizes would make it hard to predict. Below -2, all
  // results are less than a half.
  constexpr std::int64_t highest = 34;
  constexpr std::int64_t lowest = -2;
  FIXED_ASSERT(error >= 0 && error >> 54 == 0);
  const std::int64_t units = exponent.whole + fraction_bits;
  const int place =
      static_cast<int>(chosen(units < lowest, lowest, chosen(units > highest, highest, units)));
  // In units of 2^-61, power_of_two() is off by less than 5, or with five terms by 2^20 + 1. An
  // error of the exponent adds less than log(2)/4 of that error, and a little more if the error is
  // large.
  constexpr std::int64_t own_error = Terms == quick_power_terms ? 1048578 : 6;
  const std::uint64_t fraction = chosen(units == place, exponent.fraction, std::uint64_t{0});
  const auto power = static_cast<std::int64_t>(power_of_two<Terms>(fraction) >> 2);
  nearest_ends ends = nearest_within(power, error / 4 + own_error, 61 - place);
  // Beyond, both ends are out of range or 0.
  ends.high = chosen(units == place, ends.high, ends.low);
  return ends;
}

/// Like nearest_exponential(), but without the quick try.
///
/// Only a power of two with a whole exponent is rational.
template <exponential_base Base, rounding Rounding>
constexpr std::int64_t careful_exponential(std::int64_t x, const binary_exponent& exponent,
                                           std::int64_t error, int fraction_bits) noexcept {
  const std::int64_t place = exponent.whole + fraction_bits;
  if (place >= -2 && place < 34 &&
      (x == 0 || (Base == exponential_base::two && exponent.fraction == 0))) {
    return shift_right<Rounding>(std::int64_t{1} << (place + 2), 2);
  }
  const nearest_ends ends = power_within<power_terms>(exponent, error, fraction_bits);
  if (ends.agree()) [[likely]]
    return ends.low;
  real precise = real{x} << (real_bits - 32);
  if constexpr (Base == exponential_base::e) precise = product(precise, real_from(real_log2_e));
  return nearest_precise_power(precise, fraction_bits);
}

/// The exponential of x / 2^32 in units of 2^-fraction_bits, rounded to nearest, ties by rule
/// Rounding; any integer from 2^33 on for a result that is not below 2^34 units.
template <exponential_base Base, rounding Rounding>
constexpr std::int64_t nearest_exponential(std::int64_t x, int fraction_bits) noexcept {
  const binary_exponent exponent = exponent_of<Base>(x);
  // |x| is below 24 * 2^32 unless the result is out of range.
  constexpr std::int64_t error = Base == exponential_base::two ? 0 : 49;
  if (fraction_bits <= quick_bits) {
    const nearest_ends quick = power_within<quick_power_terms>(exponent, error, fraction_bits);
    if (quick.agree()) [[likely]]
      return quick.low;
  }
  return careful_exponential<Base, Rounding>(x, exponent, error, fraction_bits);
}

/// The logarithm of 2 in a base.
struct logarithm_scale {
  std::int64_t whole = 0;      ///< in units of 2^-57, to nearest
  std::uint64_t fraction = 0;  ///< in units of 2^-64, rounded down
  real precise;
};

template <logarithm_base Base>
FIXED_CONSTANT logarithm_scale scale_of = [] {
  // The fraction of base two is 2^64, which becomes 0; nothing takes it.
  const auto scale = [](const real& precise) -> logarithm_scale {
    return {static_cast<std::int64_t>(((precise >> (real_bits - 58)) + real{1}) >> 1),
            static_cast<std::uint64_t>(precise >> (real_bits - 64)), precise};
  };
  if constexpr (Base == logarithm_base::two) return scale(real_one);
  if constexpr (Base == logarithm_base::e) return scale(real_from(real_log_2));
  if constexpr (Base == logarithm_base::ten) return scale(real_from(real_log10_2));
}();

/// log2(m / 2^32) in units of 2^-64, for 2^32 <= m < 2^33. The error is below 5 units.
///
/// A reciprocal c of the leading six bits makes m c = 1 + r with 0 <= r < 2^-6 + 2^-32, without an
/// error. The Taylor series loses at most 3 units, its remainder is below 2^-68, and the logarithm
/// of c is to nearest. Fewer terms leave a remainder of r^(Terms + 1) log2(e) / (Terms + 1).
template <std::size_t Terms>
constexpr std::uint64_t binary_logarithm(std::uint64_t m) noexcept {
  const std::size_t interval = m >> 26 & 63;
  // m c is 2^64 (1 + r), of which 2^64 is lost; 32 r in units of 2^-64
  const std::uint64_t rest = m * reciprocals[interval] << 5;
  const std::uint64_t sum = sum_of_alternating_series<Terms>(logarithm_coefficients, rest);
  return logarithms[interval] + multiply_high(rest, sum);
}

/// The error of a binary_logarithm() with at least three terms in units of 2^-64: if terms are
/// missing, it is below 2^-(6 Terms + 7).
template <std::size_t Terms>
FIXED_CONSTANT std::int64_t logarithm_error =
    Terms == logarithm_terms ? 5 : std::int64_t{1} << (57 - 6 * Terms);

/// A number from 1 to 2 times a power of two: m / 2^32 * 2^exponent.
struct scaled_word {
  std::uint64_t m;
  int exponent;
};

/// raw / 2^fraction_bits. @pre 0 < raw < 2^33
///
/// A double has both parts. The instruction bsr, which counts zeros on x86-64, waits for the last
/// value of its destination register: in some programs each logarithm waited for the previous one.
/// LZCNT does not wait, and with -march=native the conversion to double does.
constexpr scaled_word scaled(std::uint64_t raw, int fraction_bits) noexcept {
#if defined(__LZCNT__)
  constexpr bool as_double = false;
#else
  constexpr bool as_double = hardware_double;
#endif
  if constexpr (as_double) {
    if (!std::is_constant_evaluated()) {
      constexpr std::uint64_t one = std::uint64_t{1} << 32;
      const auto bits =
          bit_cast<std::uint64_t>(static_cast<double>(static_cast<std::int64_t>(raw)));
      return {(bits >> 20 & (one - 1)) | one, static_cast<int>(bits >> 52) - 1023 - fraction_bits};
    }
  }
  const int unused = leading_zeros(raw) - 31;
  return {raw << unused, 32 - unused - fraction_bits};
}

/// The binary logarithm. Its error is below 2^-168.
constexpr real precise_logarithm(const scaled_word& x) noexcept {
  return (real{x.exponent} << real_bits) + precise_logarithm(x.m);
}

/// The ends of the logarithm of x in units of 2^-fraction_bits.
template <logarithm_base Base, std::size_t Terms>
constexpr nearest_ends logarithm_within(const scaled_word& x, int fraction_bits) noexcept {
  const std::uint64_t fraction = binary_logarithm<Terms>(x.m);
  // At most 32 * 2^57, and the fraction adds less than 2^57.
  FIXED_ASSERT(x.exponent >= -32 && x.exponent <= 32);
  std::int64_t value = x.exponent * scale_of<Base>.whole;
  if constexpr (Base == logarithm_base::two) {
    value += static_cast<std::int64_t>(fraction >> 7);
  } else {
    value += static_cast<std::int64_t>(multiply_high(fraction, scale_of<Base>.fraction) >> 7);
  }
  // In units of 2^-57, the whole exponent is off by at most 16.5, and the rest is rounded twice.
  constexpr std::int64_t error = logarithm_error<Terms> / 128 + 20;
  return nearest_within(value, error, 57 - fraction_bits);
}

/// The logarithm of x in units of 2^-fraction_bits, rounded to nearest.
template <logarithm_base Base>
constexpr std::int64_t careful_logarithm(const scaled_word& x, int fraction_bits) noexcept {
  const nearest_ends ends = logarithm_within<Base, logarithm_terms>(x, fraction_bits);
  if (ends.agree()) [[likely]]
    return ends.low;
  return nearest_units(product(precise_logarithm(x), scale_of<Base>.precise), fraction_bits);
}

/// The logarithm of raw / 2^operand_bits in units of 2^-fraction_bits, rounded to nearest. There
/// are no ties: a logarithm of a rational number is whole or irrational in these bases.
/// @pre 0 < raw < 2^33
template <logarithm_base Base>
constexpr std::int64_t nearest_logarithm(std::uint64_t raw, int operand_bits,
                                         int fraction_bits) noexcept {
  const scaled_word x = scaled(raw, operand_bits);
  if (fraction_bits <= quick_bits) {
    const auto quick = logarithm_within<Base, quick_logarithm_terms>(x, fraction_bits);
    if (quick.agree()) [[likely]]
      return quick.low;
  }
  return careful_logarithm<Base>(x, fraction_bits);
}

}  // namespace fixproof::detail
