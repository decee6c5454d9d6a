/// @file
/// Decodes and encodes binary floating point with integers, so that compiler flags, the rounding
/// mode and flushed denormals have no effect.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/bit_cast.hpp"
#include "fixed/detail/bits.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail {

/// The supported floating-point types: IEEE binary32 and binary64.
template <class Type>
concept binary_float = std::same_as<Type, float> || std::same_as<Type, double>;

/// A floating-point value times 2^n, rounded to an integer.
template <class Wide>
struct scaled_float {
  enum class kind {
    finite,    ///< `integer` is the result
    beyond,    ///< the result exceeds every Raw; `integer` is the result modulo 2^64
    infinite,  ///< `integer` is 0
    nan,       ///< `integer` is 0
  };
  kind what;
  bool negative;
  Wide integer;
};

/// x * 2^scale rounded by rule Rounding, for 0 <= scale <= 64. @tparam Wide signed, of 64 bits or
/// more
template <rounding Rounding, class Wide, binary_float Float>
constexpr scaled_float<Wide> scale(Float x, int scale) noexcept {
  using kind = typename scaled_float<Wide>::kind;
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
    return {significand == 0 ? kind::infinite : kind::nan, negative, Wide{0}};
  }
  if (biased != 0) significand += std::int64_t{1} << significand_bits;
  const std::int64_t value = negative ? -significand : significand;
  const int exponent =
      (biased == 0 ? 1 : biased) - (limits::max_exponent - 1) - significand_bits + scale;
  if (exponent < 0) {
    // The significand has at most 53 bits, so a shift beyond 60 equals a shift by 60.
    return {kind::finite, negative,
            Wide{shift_right<Rounding>(value, exponent < -60 ? 60 : -exponent)}};
  }
  constexpr int room = static_cast<int>(8 * sizeof(Wide)) - 54;
  if (exponent <= room) return {kind::finite, negative, Wide{value} << exponent};
  const std::uint64_t low =
      exponent < 64 ? static_cast<std::uint64_t>(value) << exponent : std::uint64_t{0};
  return {kind::beyond, negative, Wide{static_cast<std::int64_t>(low)}};
}

/// raw / 2^FractionBits to the nearest Float, ties to even.
template <binary_float Float, int FractionBits, class Raw>
// NOLINTNEXTLINE(readability-function-cognitive-complexity): two branches, for narrow and wide
constexpr Float to_float(Raw raw) noexcept {
  // Signed for narrow numbers, which is faster.
  using word =
      std::conditional_t<(sizeof(Raw) < sizeof(std::int64_t)), std::int64_t, std::uint64_t>;
  constexpr int digits = std::numeric_limits<Float>::digits;
  const bool negative = raw < 0;
  const word magnitude = negative ? word{0} - static_cast<word>(raw) : static_cast<word>(raw);
  const auto width = width_of(static_cast<std::uint64_t>(magnitude));
  const int dropped = width > digits ? width - digits : 0;
  word kept = magnitude >> dropped;
  if (dropped > 0) {
    const word rest = magnitude - (kept << dropped);
    const word half = word{1} << (dropped - 1);
    kept += rest > half || (rest == half && kept % 2 != 0) ? 1 : 0;
  }
  // Every step from here on is exact: the digits of a Float and powers of two.
  if constexpr (std::is_signed_v<word>) {
    const word rounded = kept << dropped;
    return static_cast<Float>(negative ? -rounded : rounded) /
           static_cast<Float>(word{1} << FractionBits);
  } else {
    auto value = static_cast<Float>(static_cast<std::int64_t>(negative ? 0 - kept : kept));
    for (int scale = dropped - FractionBits; scale != 0;) {
      const int step = scale < -62 || scale > 62 ? 62 : scale < 0 ? -scale : scale;
      const auto power = static_cast<Float>(std::int64_t{1} << step);
      value = scale < 0 ? value / power : value * power;
      scale += scale < 0 ? step : -step;
    }
    return value;
  }
}

}  // namespace fixproof::detail
