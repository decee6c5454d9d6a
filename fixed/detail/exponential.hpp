/// \file
/// Exponentials and logarithms of words of at most 32 bits, each the nearest integer of ulps.
///
/// A result is first computed in 64 bits with a bound of its error. If the bound allows two
/// integers, which happens about once in 2^(57 - FractionBits) operands, it is computed again with
/// an error below 2^-110. By Lindemann's theorem and the theorem of Gelfond and Schneider no
/// irrational result is a tie, and rational results are handled apart.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/cosine.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/precise_exponential.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail {

enum class exponential_base { two, e };

/// 2^(x / 2^64) in units of 2^-63, at most 15 units too low and never too high.
///
/// The table takes 5 bits of x. The Taylor series of the rest loses at most 2 units in each of
/// eight steps, counted in units of 2^-64, and its remainder is below 2^-68.
constexpr std::uint64_t power_of_two(std::uint64_t x) noexcept {
  const std::uint64_t rest = x << 5;
  std::uint64_t sum = power_coefficients.back();
  for (std::size_t n = power_coefficients.size() - 1; n-- > 0;) {
    sum = power_coefficients[n] + multiply_high(rest, sum);
  }
  const std::uint64_t power = powers_of_two[x >> 59];
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
    const auto magnitude =
        x < 0 ? 0 - static_cast<std::uint64_t>(x) : static_cast<std::uint64_t>(x);
    const two_words product = multiply_words(magnitude, log2_e);
    const auto whole = static_cast<std::int64_t>(product.high >> 31);
    const std::uint64_t fraction = product.high << 33 | product.low >> 31;
    if (x >= 0) return {whole, fraction};
    return {fraction == 0 ? -whole : -whole - 1, 0 - fraction};
  }
}

/// The exponential of x / 2^32 rounded to units of 2^-FractionBits, for an irrational result.
template <exponential_base Base, int FractionBits>
constexpr std::int64_t precise_exponential(std::int64_t x) noexcept {
  real exponent = real{x} << (real_bits - 32);
  if constexpr (Base == exponential_base::e) exponent = product(exponent, real_from(real_log2_e));
  const int whole = static_cast<int>(static_cast<std::int64_t>(exponent >> real_bits));
  const real power = precise_power(exponent - (real{whole} << real_bits));
  const int shift = real_bits - 1 - FractionBits - whole;
  return (static_cast<std::int64_t>(power >> shift) + 1) >> 1;
}

/// The exponential of x / 2^32 in units of 2^-FractionBits, rounded to nearest, ties by rule R;
/// 2^33 for every result that is not below 2^32 units.
///
/// Only a power of two with a whole exponent is rational.
template <exponential_base Base, rounding R, int FractionBits>
constexpr std::int64_t nearest_exponential(std::int64_t x) noexcept {
  constexpr std::int64_t above_all = std::int64_t{1} << 33;
  // Beyond, the exponent of 2 is above 64, and every format ends below 2^32.
  constexpr std::int64_t limit = std::int64_t{64} << 32;
  if (x >= limit) return above_all;
  if (x <= -limit) return 0;
  const binary_exponent exponent = exponent_of<Base>(x);
  const auto place = static_cast<int>(exponent.whole) + FractionBits;
  if (place >= 32) return above_all;
  if (place < -2) return 0;
  if (x == 0 || (Base == exponential_base::two && exponent.fraction == 0)) {
    return shift_right<R>(std::int64_t{1} << (place + 2), 2);
  }
  // In units of 2^-62, power_of_two() is off by at most 8. |x| is below 24 * 2^32 here, so the
  // error of the exponent is below 49 * 2^-64, which adds 18.
  constexpr std::uint64_t error = 32;
  const std::uint64_t power = power_of_two(exponent.fraction) >> 1;
  const std::uint64_t low = (power - error) >> (61 - place);
  const std::uint64_t high = (power + error) >> (61 - place);
  if ((low + 1) >> 1 == (high + 1) >> 1) return static_cast<std::int64_t>((low + 1) >> 1);
  return precise_exponential<Base, FractionBits>(x);
}

enum class logarithm_base { two, e, ten };

/// The logarithm of 2 in a base.
struct logarithm_scale {
  std::int64_t whole;      ///< in units of 2^-57, to nearest
  std::uint64_t fraction;  ///< in units of 2^-64, rounded down
  real precise;
};

template <logarithm_base Base>
inline constexpr logarithm_scale scale_of = [] {
  const auto scale = [](const real& precise) -> logarithm_scale {
    return {static_cast<std::int64_t>(((precise >> (real_bits - 58)) + real{1}) >> 1),
            static_cast<std::uint64_t>(precise >> (real_bits - 64)), precise};
  };
  if constexpr (Base == logarithm_base::two) return scale(real_one);
  if constexpr (Base == logarithm_base::e) return scale(real_from(real_log_2));
  if constexpr (Base == logarithm_base::ten) return scale(real_from(real_log10_2));
}();

/// log2(m / 2^31) in units of 2^-64, for 2^31 <= m < 2^32. The error is below 5 units.
///
/// A reciprocal c of the leading six bits makes m c = 1 + r with 0 <= r < 2^-6 + 2^-32, without an
/// error. The Taylor series loses at most 3 units, its remainder is below 2^-68, and the logarithm
/// of c is to nearest.
constexpr std::uint64_t binary_logarithm(std::uint32_t m) noexcept {
  const std::size_t interval = m >> 25 & 63;
  // r in units of 2^-69, which is 32 r in units of 2^-64
  const std::uint64_t rest = (m * reciprocals[interval] - (std::uint64_t{1} << 63)) << 6;
  std::uint64_t sum = logarithm_coefficients.back();
  for (std::size_t n = logarithm_coefficients.size() - 1; n-- > 0;) {
    sum = logarithm_coefficients[n] - multiply_high(rest, sum);
  }
  return logarithms[interval] + multiply_high(rest, sum);
}

/// The logarithm of raw / 2^FractionBits in units of 2^-FractionBits, rounded to nearest. There are
/// no ties: a logarithm of a rational number is whole or irrational in these bases.
/// \pre raw > 0
template <logarithm_base Base, int FractionBits>
constexpr std::int64_t nearest_logarithm(std::uint32_t raw) noexcept {
  const int unused = std::countl_zero(raw);
  const std::uint32_t m = raw << unused;
  const int exponent = 31 - unused - FractionBits;
  const std::uint64_t fraction = binary_logarithm(m);
  std::int64_t value = exponent * scale_of<Base>.whole;
  if constexpr (Base == logarithm_base::two) {
    value += static_cast<std::int64_t>(fraction >> 7);
  } else {
    value += static_cast<std::int64_t>(multiply_high(fraction, scale_of<Base>.fraction) >> 7);
  }
  // In units of 2^-57, the whole exponent is off by at most 16, the rest by less than 2.
  constexpr std::int64_t error = 20;
  constexpr int dropped = 57 - FractionBits;
  constexpr std::int64_t half = std::int64_t{1} << (dropped - 1);
  const std::int64_t low = (value - error + half) >> dropped;
  const std::int64_t high = (value + error + half) >> dropped;
  if (low == high) return low;
  const real all = (real{exponent} << real_bits) + precise_logarithm(m);
  const real scaled = product(all, scale_of<Base>.precise);
  return static_cast<std::int64_t>((scaled + (real_one >> (FractionBits + 1))) >>
                                   (real_bits - FractionBits));
}

}  // namespace fixproof::detail
