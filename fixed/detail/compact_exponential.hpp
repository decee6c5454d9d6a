/// @file
/// Exponentials, logarithms and hyperbolic functions, computed in compact words of at most 32 bits.
/// Each is the nearest integer of ulps.
///
/// The steps and the bounds are those of exponential.hpp and hyperbolic.hpp without their quick
/// tries. Logarithms have half of the table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/compact_words.hpp"
#include "fixed/detail/digit_exponential.hpp"
#include "fixed/detail/exponential.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/gpu.hpp"
#include "fixed/detail/hyperbolic.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail::in_compact_words {

/// power_of_two() with all terms.
FIXED_NOINLINE constexpr std::uint64_t power_of(std::uint64_t x) noexcept {
  const std::uint64_t power = powers_of_two[static_cast<std::uint32_t>(x >> 59)];
  return power +
         high_product(power, series_of(power_coefficients.data(), power_terms, x << 5, false));
}

/// exponent_of<exponential_base::e>().
constexpr binary_exponent natural_exponent_of(std::int64_t x) noexcept {
  const auto bits = static_cast<std::uint64_t>(x);
  const std::uint64_t high = high_product(bits, log2_e) - (x < 0 ? log2_e : 0);
  return {static_cast<std::int64_t>(high) >> 31, high << 33 | bits * log2_e >> 31};
}

/// 2^exponent, or `undecided`; 2^35 for every result that is not below 2^35 units.
constexpr std::int64_t power_ulps(const binary_exponent& exponent, int fraction_bits,
                                  exponential_base base, rounding ties) noexcept {
  const int place = static_cast<int>(exponent.whole) + fraction_bits;
  if (place > 34) return std::int64_t{1} << 35;
  if (place < -2) return 0;
  const std::uint64_t fraction = exponent.fraction;
  if (base == exponential_base::two && place == -1 && fraction == 0) {
    return in_digits::rounded_half(false, ties);
  }
  // power_within() allows 49/4 + 6 for an exponent that is off by 49.
  return nearest_or_undecided_within(static_cast<std::int64_t>(power_of(fraction) >> 2), 18,
                                     61 - place);
}

template <exponential_base Base>
constexpr std::int64_t exponential_ulps(std::int64_t x, int fraction_bits, rounding ties) noexcept {
  if constexpr (Base == exponential_base::e) {
    return power_ulps(natural_exponent_of(x), fraction_bits, Base, ties);
  } else {
    return power_ulps({x >> 32, static_cast<std::uint64_t>(x) << 32}, fraction_bits, Base, ties);
  }
}

/// Each second one of the reciprocals of exponential.hpp, less 2^31, so that they fit into 32 bits.
FIXED_CONSTANT std::array<std::uint32_t, 32> short_reciprocals = [] {
  std::array<std::uint32_t, 32> all{};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i] = static_cast<std::uint32_t>(reciprocals[2 * i] - (std::uint64_t{1} << 31));
  }
  return all;
}();

/// Their logarithms.
FIXED_CONSTANT std::array<std::uint64_t, 32> short_logarithms = [] {
  std::array<std::uint64_t, 32> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = logarithms[2 * i];
  return all;
}();

/// log2(1 + fraction / 2^32) in units of 2^-64. The error is below 79 units.
///
/// As binary_logarithm() with all terms, but 32 reciprocals leave r < 2^-5: the steps of the series
/// lose up to 10.5 units, and the terms after the tenth are below r^11 log2(e) / 11, less than 68.
constexpr std::uint64_t binary_logarithm_of(std::uint32_t fraction) noexcept {
  const std::uint32_t interval = fraction >> 27;
  const std::uint32_t reciprocal = short_reciprocals[interval];
  // The product of 2^32 + fraction and 2^31 + reciprocal, without 2^63, which the shift drops
  const std::uint64_t product = product_of(fraction, reciprocal) +
                                (std::uint64_t{reciprocal} << 32) + (std::uint64_t{fraction} << 31);
  return short_logarithms[interval] +
         series_of(logarithm_coefficients.data(), logarithm_terms, product << 5, true);
}

constexpr std::int64_t logarithm_ulps(std::uint64_t raw, int operand_bits, int fraction_bits,
                                      std::int64_t whole, std::uint64_t scale) noexcept {
  int exponent = 32 - operand_bits;
  for (; raw >> 32 == 0; raw <<= 1) --exponent;
  std::uint64_t fraction = binary_logarithm_of(static_cast<std::uint32_t>(raw));
  // The scale of base two is 2^64, which is 0 here.
  if (scale != 0) fraction = high_product(fraction, scale);
  return nearest_or_undecided_within(exponent * whole + static_cast<std::int64_t>(fraction >> 7),
                                     20, 57 - fraction_bits);
}

/// falling_exponential() with all terms.
constexpr std::int64_t falling(std::int64_t x) noexcept {
  const binary_exponent exponent = natural_exponent_of(-x);
  const std::int64_t shift = 1 - exponent.whole;
  return shift > 63 ? 0 : static_cast<std::int64_t>(power_of(exponent.fraction) >> shift);
}

constexpr std::int64_t hyperbolic_ulps(std::int64_t x, int fraction_bits,
                                       hyperbola function) noexcept {
  const binary_exponent up = natural_exponent_of(x);
  if (up.whole >= 34 - fraction_bits) return std::int64_t{1} << 35;
  const auto whole = static_cast<int>(up.whole);
  const std::int64_t small = falling(x) >> (whole + 1);
  const auto rising = static_cast<std::int64_t>(power_of(up.fraction) >> 2);
  const std::int64_t value = function == hyperbola::sine ? rising - small : rising + small;
  // At most 6 units too high and 19.25 too low: docs/functions/hyperbolic.md has the sums. The
  // sinh of 6.73857..., stored integer 441619, is only 19 units from a tie.
  return nearest_or_undecided(value - 6, value + 20, 62 - whole - fraction_bits);
}

constexpr std::int64_t hyperbolic_tangent_ulps(std::int64_t x, int fraction_bits) noexcept {
  if (x >= std::int64_t{13} << 32) return std::int64_t{1} << fraction_bits;
  constexpr std::uint64_t one = std::uint64_t{1} << 62;
  const auto t = static_cast<std::uint64_t>(falling(2 * x));
  std::uint64_t rest = one - t;
  const std::uint64_t high = take_quotient(rest, one + t, 30);
  const auto value = static_cast<std::int64_t>(high << 32 | take_quotient(rest, one + t, 32));
  return nearest_or_undecided_within(value, 24, 62 - fraction_bits);
}

// Constant expressions compute in words; variant.hpp has the reasons.

template <exponential_base Base, rounding Rounding, class Bits>
constexpr std::int64_t nearest_exponential(std::int64_t x, Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated())
    return detail::nearest_exponential<Base, Rounding>(x, fraction_bits);
  return decided<is_tried<Bits>>(exponential_ulps<Base>(x, fraction_bits, Rounding), [&] {
    return in_digits::exponential_ulps(x, fraction_bits, Base, Rounding);
  });
}

template <logarithm_base Base, class Bits>
constexpr std::int64_t nearest_logarithm(std::uint64_t raw, int operand_bits,
                                         Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated()) {
    return detail::nearest_logarithm<Base>(raw, operand_bits, fraction_bits);
  }
  return decided<is_tried<Bits>>(
      logarithm_ulps(raw, operand_bits, fraction_bits, scale_of<Base>.whole,
                     scale_of<Base>.fraction),
      [&] { return in_digits::logarithm_ulps(raw, operand_bits, fraction_bits, Base); });
}

template <hyperbola Function, class Bits>
constexpr std::int64_t nearest_hyperbolic(std::int64_t x, Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated())
    return detail::nearest_hyperbolic<Function>(x, fraction_bits);
  return decided<is_tried<Bits>>(hyperbolic_ulps(x, fraction_bits, Function), [&] {
    return in_digits::hyperbolic_ulps(x, fraction_bits, Function);
  });
}

template <class Bits>
constexpr std::int64_t nearest_hyperbolic_tangent(std::int64_t x, Bits fraction_bits) noexcept {
  if (__builtin_is_constant_evaluated())
    return detail::nearest_hyperbolic_tangent(x, fraction_bits);
  return decided<is_tried<Bits>>(hyperbolic_tangent_ulps(x, fraction_bits), [&] {
    return in_digits::hyperbolic_tangent_ulps(x, fraction_bits);
  });
}

}  // namespace fixproof::detail::in_compact_words
