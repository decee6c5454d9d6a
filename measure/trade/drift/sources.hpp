/// @file
/// Number types that each leave out one source of rotation error.
///
/// Rotations that are appended step by step have three sources of error. Sines and cosines are
/// rounded to 16.16, so each step stretches or shrinks the object a little, always the same way.
/// Every product is rounded. The published conversion makes nearly every negative constant one unit
/// too large; Conversion::nearest avoids that.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <numeric>
#include <optional>

#include "fixed/policy.hpp"
#include "xsharp/arithmetic.hpp"

namespace fixproof::trade {

/// A double whose products are rounded by `Rule`.
template <class Rule>
struct Partly {
  double value = 0;

  friend constexpr Partly operator+(Partly a, Partly b) { return {a.value + b.value}; }
  friend constexpr Partly operator-(Partly a, Partly b) { return {a.value - b.value}; }
  constexpr Partly operator-() const { return {-value}; }
  friend Partly operator*(Partly a, Partly b) { return {Rule::product(a.value * b.value)}; }
  friend constexpr bool operator==(Partly, Partly) = default;
  friend constexpr auto operator<=>(Partly, Partly) = default;
  explicit constexpr operator double() const { return value; }
};

/// Rounded sines and cosines, exact products.
struct ExactProducts {
  static double product(double exact) { return exact; }
  static double constant(double value, xsharp::Conversion conversion) {
    return xsharp::raw_constant(value, conversion) / 65536.0;
  }
};

/// Exact sines and cosines; every product is rounded as in a listing.
template <fixproof::rounding rounding>
struct ExactSteps {
  static double product(double exact) {
    const double units = exact * 65536.0;
    switch (rounding) {
      case fixproof::rounding::half_up:
        return std::floor(units + 0.5) / 65536.0;
      case fixproof::rounding::half_away:
        return std::copysign(std::floor(std::fabs(units) + 0.5), units) / 65536.0;
      case fixproof::rounding::floor:
        return std::floor(units) / 65536.0;
      case fixproof::rounding::ceiling:
        return std::ceil(units) / 65536.0;
      case fixproof::rounding::truncate:
        return std::trunc(units) / 65536.0;
      case fixproof::rounding::half_even:
      case fixproof::rounding::nearest:
        return std::nearbyint(units) / 65536.0;
    }
    return exact;
  }
  static double constant(double value, xsharp::Conversion /*conversion*/) { return value; }
};

}  // namespace fixproof::trade

namespace xsharp {

template <class Rule>
struct Arithmetic<fixproof::trade::Partly<Rule>> {
  using N = fixproof::trade::Partly<Rule>;

  static N from_raw(std::int32_t raw) { return {raw / 65536.0}; }
  static N constant(double value, Conversion conversion) {
    return {Rule::constant(value, conversion)};
  }
  static Turn<N> turn(std::int32_t tenths) {
    // The table holds the nearest values.
    return {constant(std::cos(radians(tenths)), Conversion::nearest),
            constant(std::sin(radians(tenths)), Conversion::nearest)};
  }
  // Quotients and lengths are not rounded: an appended rotation needs none.
  static std::optional<N> divide(N n, N d) { return N{n.value / d.value}; }
  static constexpr bool divides_by_whole_part() { return false; }
  static N length(const Vec3<N>& v) { return {std::hypot(v.x.value, v.y.value, v.z.value)}; }
};

}  // namespace xsharp
