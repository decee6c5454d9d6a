/// @file
/// Sine and cosine. sin, cos and sin_cos take radians. sin_of_tenths and the functions like it take
/// integers in tenths of a degree, as CosSin of FIXED.ASM does, and name the type of the result.
/// Radians need 8.8 or 16.16; tenths of a degree need a signed type of at most 32 bits that can
/// represent 1 and has a fraction bit.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "fixed/detail/cosine_table.hpp"
#include "fixed/detail/instead.hpp"
#include "fixed/detail/operands.hpp"
#include "fixed/detail/radian.hpp"
#include "fixed/number.hpp"

namespace fixproof {

/// The result of sin_cos() and the functions like it. As in their names, the sine comes first.
template <class Number>
struct sin_and_cos {
  Number sin;  ///< The sine.
  Number cos;  ///< The cosine.

  /// Whether both members are equal.
  friend constexpr bool operator==(const sin_and_cos&, const sin_and_cos&) = default;
};

/// The sine and the cosine of an angle in tenths of a degree, each rounded to nearest. Accepts any
/// value of any integer type; the period is 3600. The same under every policy.
///
///     const auto [sin, cos] = fixproof::sin_cos_of_tenths<fixproof::q16_16>(450);
///     // The period is 3600.
///     static_assert(sin_cos_of_tenths<q16_16>(-3300) == sin_cos_of_tenths<q16_16>(300));
///     static_assert(fixproof::sin_of_tenths<q16_16>(300) == q16_16(0.5));
template <class Number>
[[nodiscard]] constexpr sin_and_cos<Number> sin_cos_of_tenths(std::integral auto angle) noexcept {
  static_assert(std::is_signed_v<typename Number::raw_type> &&
                    detail::bits_of<typename Number::raw_type> <= 32 &&
                    Number::fraction_bits <= detail::bits_of<typename Number::raw_type> - 2 &&
                    Number::fraction_bits > 0,
                "the result of sin_cos_of_tenths() is a signed number of at most 32 "
                "bits that can represent 1 and 1/2");
  constexpr std::int32_t turn = 3600;
  constexpr std::int32_t half_turn = turn / 2;
  constexpr const auto& table = detail::sine_table<Number::fraction_bits, turn / 360>;
  // Masks, because a processor cannot predict signs and halves. Half a turn changes both signs.
  const auto from_zero = static_cast<std::int32_t>(angle % turn);
  const std::int32_t in_turn = from_zero + ((from_zero >> 31) & turn);
  const std::int32_t sign = (half_turn - 1 - in_turn) >> 31;
  const auto step = static_cast<std::size_t>(in_turn - (sign & half_turn));
  const auto result = [sign](std::int32_t magnitude) {
    return Number::from_raw(static_cast<typename Number::raw_type>((magnitude ^ sign) - sign));
  };
  return {result(table[step]), result(table[step + turn / 4])};
}

/// The cosine of an angle in tenths of a degree; see sin_cos_of_tenths().
template <class Number>
[[nodiscard]] constexpr Number cos_of_tenths(std::integral auto angle) noexcept {
  return sin_cos_of_tenths<Number>(angle).cos;
}

/// The sine of an angle in tenths of a degree; see sin_cos_of_tenths().
template <class Number>
[[nodiscard]] constexpr Number sin_of_tenths(std::integral auto angle) noexcept {
  return sin_cos_of_tenths<Number>(angle).sin;
}

/// The number nearest to the sine of any angle in radians; there are no ties. For bounds, see
/// fixed/trigonometry.hpp.
///
///     static_assert(sin(q16_16(1)) == q16_16(0.84147098480789650665));
///     static_assert(sin(q16_16(-32768)).raw() == -60808);  // -60807.99
template <class Raw, int Point, policy Rules>
requires detail::has_radians<Raw, Point, Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> sin(number<Raw, Point, Rules> angle) noexcept {
  return number<Raw, Point, Rules>::from_raw(
      static_cast<Raw>(detail::nearest_sine<Point>(angle.raw(), 0)));
}

/// The number nearest to the cosine of any angle in radians; there are no ties.
///
///     static_assert(cos(q16_16()) == q16_16(1) && cos(q16_16(-2)) == cos(q16_16(2)));
template <class Raw, int Point, policy Rules>
requires detail::has_radians<Raw, Point, Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> cos(number<Raw, Point, Rules> angle) noexcept {
  return number<Raw, Point, Rules>::from_raw(
      static_cast<Raw>(detail::nearest_sine<Point>(angle.raw(), detail::quarter_turn)));
}

/// sin() and cos() of an angle in radians.
///
///     const auto [sin, cos] = fixproof::sin_cos(fixproof::q16_16(0.5));
template <class Raw, int Point, policy Rules>
requires detail::has_radians<Raw, Point, Rules>
[[nodiscard]] constexpr sin_and_cos<number<Raw, Point, Rules>> sin_cos(
    number<Raw, Point, Rules> angle) noexcept {
  return {sin(angle), cos(angle)};
}

/// @cond
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares functions
#define FIXED_REFUSED_ANGLE(name)                                                           \
  template <class Number, class Type>                                                       \
  requires std::is_arithmetic_v<Type> Number name(Type)                                     \
  FIXED_INSTEAD("angles are numbers in radians, " #name "(q16_16(0.5)); in degrees: " #name \
                "_of_tenths<q16_16>(300)");                                                 \
  template <class Number, class Type>                                                       \
  requires(!std::integral<Type>) Number name##_of_tenths(Type)                              \
      FIXED_INSTEAD("angles are whole tenths of a degree: " #name                           \
                    "_of_tenths<q16_16>(300) is for 30.0 degrees");
FIXED_REFUSED_ANGLE(sin)
FIXED_REFUSED_ANGLE(cos)
FIXED_REFUSED_ANGLE(sin_cos)
#undef FIXED_REFUSED_ANGLE
FIXED_REFUSED_PLAIN(sin)
FIXED_REFUSED_PLAIN(cos)
/// @endcond

}  // namespace fixproof
