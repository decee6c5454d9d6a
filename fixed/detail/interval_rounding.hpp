/// @file
/// What the functions in formats of 64 bits, and bounds in every format, have in common: operands,
/// and an interval rounded to an integer of ulps.
///
/// Each result is computed with 192 bits. If its interval has two nearest integers, it is computed
/// again with 320 and with 576 bits. Only a tie needs more; integers find those first. A bound
/// is decided in the same way, except that only a result that is an integer needs more.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/gpu.hpp"
#include "fixed/detail/interval.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// magnitude * 2^-places with a sign.
struct real_operand {
  bool is_negative;
  std::uint64_t magnitude;
  int places;

  [[nodiscard]] constexpr interval with(std::size_t digits) const noexcept {
    return {digits, is_negative, magnitude, places};
  }
  [[nodiscard]] constexpr real_operand absolute() const noexcept {
    return {false, magnitude, places};
  }
  /// The magnitude, rounded down.
  [[nodiscard]] constexpr std::uint64_t whole() const noexcept {
    return places < 64 ? magnitude >> places : 0;
  }
  [[nodiscard]] constexpr bool is_whole() const noexcept {
    return places < 64 ? magnitude >> places << places == magnitude : magnitude == 0;
  }
  /// The part after the point, without a sign.
  [[nodiscard]] constexpr real_operand fraction() const noexcept {
    return {false, places < 64 ? magnitude - (magnitude >> places << places) : magnitude, places};
  }
  /// Whether the magnitude is 1.
  [[nodiscard]] constexpr bool is_one() const noexcept { return is_whole() && whole() == 1; }
};

template <class Number>
constexpr real_operand real_operand_of(Number x) noexcept {
  const auto bits = static_cast<std::uint64_t>(x.raw());
  const bool is_negative = x.raw() < 0;
  return {is_negative, is_negative ? 0 - bits : bits, Number::fraction_bits};
}

/// Out of range in every format.
FIXED_CONSTANT int128 far_ulps = int128{1} << 66;

constexpr auto with_sign(const auto& value, bool is_negative) noexcept {
  return is_negative ? -value : value;
}

/// Whether a rule gives bounds.
template <rounding Rounding>
inline constexpr bool is_bound = !is_to_nearest<Rounding>;

/// compute(digits), an interval, rounded to an integer of ulps. @pre it is no tie
///
/// If most_digits do not decide, it is the nearest integer. A bound is then taken as that integer
/// itself; docs/functions/interval.md says what is proven of this.
template <rounding Rounding, class Compute>
constexpr int128 certain_ulps(int fraction_bits, const Compute& compute) noexcept {
  for (const std::size_t digits : {std::size_t{6}, std::size_t{10}, interval::most_digits}) {
    const interval result = compute(digits);
    if constexpr (is_bound<Rounding>) {
      const interval_ulps bound = result.template directed_ulps<Rounding>(fraction_bits);
      if (bound.is_decided) return bound.ulps;
      if (digits < interval::most_digits) continue;
    }
    const interval_ulps nearest = result.nearest_ulps(fraction_bits);
    if (nearest.is_decided || digits == interval::most_digits) {
      FIXED_ASSERT(nearest.is_decided);
      return nearest.ulps;
    }
  }
  return int128{0};
}

/// A number that is above or below an integer of ulps by less than a half, rounded.
template <rounding Rounding>
constexpr int128 beside(const int128& ulps, bool is_above) noexcept {
  const int128 below = is_above ? ulps : ulps - int128{1};
  if constexpr (Rounding == rounding::floor) return below;
  if constexpr (Rounding == rounding::ceiling) return below + int128{1};
  if constexpr (Rounding == rounding::truncate) {
    return below < int128{0} ? below + int128{1} : below;
  }
  return ulps;
}

}  // namespace fixproof::detail
