/// @file
/// Functions of angles and angles of vectors by intervals: an integer of ulps.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/interval.hpp"
#include "fixed/detail/interval_constants.hpp"
#include "fixed/detail/interval_functions.hpp"
#include "fixed/detail/interval_rounding.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The angle in quarter turns.
template <angle_unit Unit>
constexpr interval quarters_of(const interval& x) noexcept {
  if constexpr (Unit == angle_unit::radian) {
    return x * interval(x.size(), quarters_of_radian);
  } else if constexpr (Unit == angle_unit::degree) {
    return x / 90;
  } else {
    return x.scaled(2);
  }
}

/// The number of whole quarter turns next to an angle that is not negative, and the cosine and the
/// sine of the rest.
struct reduced_angle {
  std::uint64_t quarters = 0;
  interval_cos_sin rest;
};

template <angle_unit Unit>
constexpr reduced_angle reduced(const real_operand& angle, std::size_t digits) noexcept {
  const interval x = (Unit == angle_unit::turn ? angle.fraction() : angle.absolute()).with(digits);
  const interval all = quarters_of<Unit>(x);
  const std::uint64_t whole = all.nearest_integer();
  const interval rest = all - whole_like(all, whole);
  return {whole, cos_sin_of(rest * interval(x.size(), real_half_pi), x.size())};
}

/// The sine of an angle plus `ahead` quarter turns, 0 or 1.
template <angle_unit Unit, rounding Rounding>
constexpr int128 interval_sine(const real_operand& x, unsigned ahead, int fraction_bits) noexcept {
  const bool is_flipped = x.is_negative && ahead == 0;
  // By Niven's theorem only 1/2 can be a tie, and only in a format of integers.
  if (Unit == angle_unit::degree && fraction_bits == 0 && x.is_whole()) {
    const std::uint64_t degrees = (x.whole() % 360 + std::uint64_t{90} * ahead) % 360;
    if (degrees % 180 == 30 || degrees % 180 == 150) {
      return shift_right<Rounding>(int128{(degrees > 180) != is_flipped ? -1 : 1}, 1);
    }
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const reduced_angle angle = reduced<Unit>(x, digits);
    const std::uint64_t quarters = angle.quarters + ahead;
    const interval sine = quarters % 2 == 0 ? angle.rest.sin : angle.rest.cos;
    return (quarters % 4 >= 2) != is_flipped ? -sine : sine;
  });
}

/// Whether the tangent has a pole there.
template <angle_unit Unit>
constexpr bool is_tangent_pole(const real_operand& x) noexcept {
  if constexpr (Unit == angle_unit::degree) {
    return x.is_whole() && x.whole() % 180 == 90;
  } else if constexpr (Unit == angle_unit::turn) {
    const real_operand quarters{false, x.magnitude, x.places - 2};
    return x.places >= 2 && quarters.is_whole() && quarters.whole() % 2 != 0;
  } else {
    return false;
  }
}

/// @pre there is no pole
template <angle_unit Unit, rounding Rounding>
constexpr int128 interval_tangent(const real_operand& x, int fraction_bits) noexcept {
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const auto [quarters, rest] = reduced<Unit>(x, digits);
    const interval tangent = quarters % 2 == 0 ? rest.sin / rest.cos : -(rest.cos / rest.sin);
    return x.is_negative ? -tangent : tangent;
  });
}

/// The angle in its unit, from radians.
template <angle_unit Unit>
constexpr interval angle_in(const interval& radians) noexcept {
  if constexpr (Unit == angle_unit::radian) {
    return radians;
  } else {
    const interval quarters = radians * interval(radians.size(), quarters_of_radian);
    return Unit == angle_unit::degree ? quarters * whole_like(radians, 90) : quarters.scaled(-2);
  }
}

/// An exact angle of some eighths of a turn. Only these can be ties, and only in turns: by Niven's
/// theorem, other rational angles have no rational tangent, and no sine but 1/2, at a twelfth.
template <rounding Rounding>
constexpr int128 eighths_of_turn(int eighths, bool is_negative, int fraction_bits) noexcept {
  return shift_right<Rounding>(with_sign(int128{eighths} << fraction_bits, is_negative), 3);
}

/// The angle of the vector (x, y); 0 if both are 0. @pre both have the same number of places
template <angle_unit Unit, rounding Rounding>
constexpr int128 interval_vector_angle(const real_operand& y, const real_operand& x,
                                       int fraction_bits) noexcept {
  if (y.magnitude == 0 && !x.is_negative) return int128{0};
  if constexpr (Unit == angle_unit::turn) {
    const int eighths = y.magnitude == 0             ? 4
                        : x.magnitude == 0           ? 2
                        : x.magnitude != y.magnitude ? 0
                        : x.is_negative              ? 3
                                                     : 1;
    if (eighths != 0) return eighths_of_turn<Rounding>(eighths, y.is_negative, fraction_bits);
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval angle = angle_of_vector(y.absolute().with(digits), x.with(digits));
    return with_sign(angle_in<Unit>(angle), y.is_negative);
  });
}

/// The angle whose tangent is x.
template <angle_unit Unit, rounding Rounding>
constexpr int128 interval_slope_angle(const real_operand& x, int fraction_bits) noexcept {
  if (Unit == angle_unit::turn && x.is_one()) {
    return eighths_of_turn<Rounding>(1, x.is_negative, fraction_bits);
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval slope = x.absolute().with(digits);
    const interval angle = angle_of_vector(slope, whole_like(slope, 1));
    return with_sign(angle_in<Unit>(angle), x.is_negative);
  });
}

/// The arcsine or arccosine. @pre |x| <= 1
template <angle_unit Unit, triangle_side Side, rounding Rounding>
constexpr int128 interval_triangle_angle(const real_operand& x, int fraction_bits) noexcept {
  constexpr bool is_sine = Side == triangle_side::sine;
  if constexpr (Unit == angle_unit::turn) {
    if (x.magnitude == 0) return eighths_of_turn<Rounding>(is_sine ? 0 : 2, false, fraction_bits);
    if (x.is_one()) {
      const int eighths = is_sine ? 2 : x.is_negative ? 4 : 0;
      return eighths_of_turn<Rounding>(eighths, is_sine && x.is_negative, fraction_bits);
    }
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval side = x.with(digits);
    const interval one = whole_like(side, 1);
    const interval other = sqrt((one - side) * (one + side));
    const interval angle =
        is_sine ? angle_of_vector(side.magnitude(), other) : angle_of_vector(other, side);
    return with_sign(angle_in<Unit>(angle), is_sine && x.is_negative);
  });
}

}  // namespace fixproof::detail
