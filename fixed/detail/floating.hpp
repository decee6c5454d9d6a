/// \file
/// Decodes and encodes binary floating point with integers, so that compiler flags, the rounding
/// mode and flushed denormals have no effect.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/bit_cast.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail {

/// The supported floating-point types: IEEE binary32 and binary64.
template <class T>
concept binary_float = std::same_as<T, float> || std::same_as<T, double>;

/// A floating-point value times 2^n, rounded to an integer.
struct scaled_float {
  enum class kind {
    finite,    ///< `integer` is the result
    beyond,    ///< the result exceeds 64 bits; `integer` is it modulo 2^64
    infinite,  ///< `integer` is 0
    nan,       ///< `integer` is 0
  };
  kind what;
  bool negative;
  std::int64_t integer;
};

/// x * 2^scale rounded by rule R, for 0 <= scale <= 16.
template <rounding R, binary_float Float>
constexpr scaled_float scale(Float x, int scale) noexcept {
  using kind = scaled_float::kind;
  using bits_type = std::conditional_t<sizeof(Float) == 4, std::uint32_t, std::uint64_t>;
  using limits = std::numeric_limits<Float>;
  constexpr int significand_bits = limits::digits - 1;
  constexpr int exponent_mask = 2 * limits::max_exponent - 1;
  constexpr bits_type significand_mask = (bits_type{1} << significand_bits) - 1;

  const auto bits = bit_cast<bits_type>(x);
  const bool negative = (bits >> (sizeof(Float) * 8 - 1)) != 0;
  const int biased = static_cast<int>(bits >> significand_bits) & exponent_mask;
  auto significand = static_cast<std::int64_t>(bits & significand_mask);
  if (biased == exponent_mask) {
    return {significand == 0 ? kind::infinite : kind::nan, negative, 0};
  }
  if (biased != 0) significand += std::int64_t{1} << significand_bits;
  const std::int64_t value = negative ? -significand : significand;
  const int exponent =
      (biased == 0 ? 1 : biased) - (limits::max_exponent - 1) - significand_bits + scale;
  if (exponent < 0) {
    // The significand has at most 53 bits, so a shift beyond 60 equals a shift by 60.
    return {kind::finite, negative, shift_right<R>(value, exponent < -60 ? 60 : -exponent)};
  }
  if (exponent <= 10) return {kind::finite, negative, value * (std::int64_t{1} << exponent)};
  const std::uint64_t low =
      exponent < 64 ? static_cast<std::uint64_t>(value) << exponent : std::uint64_t{0};
  return {kind::beyond, negative, static_cast<std::int64_t>(low)};
}

/// The float nearest to raw / 2^fraction_bits, ties to even.
constexpr float to_float(std::int64_t raw, int fraction_bits) noexcept {
  const std::int64_t magnitude = raw < 0 ? -raw : raw;
  const auto width = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(magnitude)));
  const int dropped = width > 24 ? width - 24 : 0;
  std::int64_t kept = magnitude >> dropped;
  if (dropped > 0) {
    const std::int64_t rest = magnitude - (kept << dropped);
    const std::int64_t half = std::int64_t{1} << (dropped - 1);
    kept += rest > half || (rest == half && kept % 2 != 0) ? 1 : 0;
  }
  const std::int64_t rounded = kept << dropped;
  // Every step from here on is exact: 24 significant bits and a power of two.
  return static_cast<float>(raw < 0 ? -rounded : rounded) /
         static_cast<float>(std::int64_t{1} << fraction_bits);
}

}  // namespace fixproof::detail
