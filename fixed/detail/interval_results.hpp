/// @file
/// The functions in formats of 64 bits, and bounds in every format: an integer of ulps.
///
/// Each result is computed with 192 bits. If its interval has two nearest integers, it is computed
/// again with 320 and with 576 bits. Only a tie needs more; integers find those first. A bound
/// is decided in the same way, except that only a result that is an integer needs more.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/bits.hpp"
#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/interval.hpp"
#include "fixed/detail/interval_constants.hpp"
#include "fixed/detail/interval_functions.hpp"
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
inline constexpr int128 far_ulps = int128{1} << 66;

constexpr auto with_sign(const auto& value, bool is_negative) noexcept {
  return is_negative ? -value : value;
}

/// Whether a rule gives bounds.
template <rounding Rounding>
inline constexpr bool is_bound = !is_to_nearest<Rounding>;

/// compute(digits), an interval, rounded to an integer of ulps. @pre it is no tie
template <rounding Rounding, class Compute>
constexpr int128 certain_ulps(int fraction_bits, const Compute& compute) noexcept {
  for (const std::size_t digits : {std::size_t{6}, std::size_t{10}, interval::most_digits}) {
    const interval result = compute(digits);
    interval_ulps ulps{};
    if constexpr (is_bound<Rounding>) {
      ulps = result.template directed_ulps<Rounding>(fraction_bits);
      // Taken as that integer; docs/functions/interval.md says what is proven of this.
      if (!ulps.is_decided && digits == interval::most_digits) {
        ulps = result.nearest_ulps(fraction_bits);
      }
    } else {
      ulps = result.nearest_ulps(fraction_bits);
    }
    if (ulps.is_decided) return ulps.ulps;
  }
  FIXED_ASSERT(false);
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

/// @name Exponentials, logarithms and hyperbolic functions
/// \{

/// From 2^7 on, an exponential is above 2^128 or below 2^-128.
constexpr bool has_far_power(const real_operand& x) noexcept { return x.whole() >= 128; }

template <exponential_base Base>
constexpr interval exponential_interval(const interval& x) noexcept {
  if constexpr (Base == exponential_base::two) {
    return power_of_two(x);
  } else {
    constexpr const real_constant& factor = Base == exponential_base::e ? log2_of_e : log2_of_10;
    return power_of_two(x * interval(x.size(), factor));
  }
}

/// The exponential, less 1 if `less`.
template <exponential_base Base, rounding Rounding>
constexpr int128 interval_exponential(const real_operand& x, bool less,
                                      int fraction_bits) noexcept {
  if (has_far_power(x)) {
    const int128 least = -(int128{less ? 1 : 0} << fraction_bits);
    return x.is_negative ? beside<Rounding>(least, true) : far_ulps;
  }
  // By the theorems of Gelfond and Schneider and of Lindemann, only a whole power of two is a tie.
  if (Base == exponential_base::two && x.is_negative && x.is_whole() &&
      x.whole() == static_cast<std::uint64_t>(fraction_bits) + 1) {
    return shift_right<Rounding>(int128{1}, 1);
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval power = exponential_interval<Base>(x.with(digits));
    return power - whole_like(power, less ? 1 : 0);
  });
}

/// The logarithm of x, or of x + 1 if `more`. @pre that is positive
template <logarithm_base Base, rounding Rounding>
constexpr int128 interval_logarithm(const real_operand& x, bool more, int fraction_bits) noexcept {
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval operand = x.with(digits);
    const interval sum = operand + whole_like(operand, more ? 1 : 0);
    if constexpr (Base == logarithm_base::e) {
      return natural_logarithm(sum);
    } else if constexpr (Base == logarithm_base::two) {
      return binary_logarithm(sum);
    } else {
      return binary_logarithm(sum) * interval(digits, log10_of_2);
    }
  });
}

template <hyperbola Function, rounding Rounding>
constexpr int128 interval_hyperbolic(const real_operand& x, int fraction_bits) noexcept {
  const bool is_odd = Function == hyperbola::sine;
  if (has_far_power(x)) return with_sign(far_ulps, is_odd && x.is_negative);
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval power = exponential_interval<exponential_base::e>(x.with(digits));
    const interval inverse = whole_like(power, 1) / power;
    return (is_odd ? power - inverse : power + inverse).scaled(-1);
  });
}

/// From 64 on, the result is 1 less 2 e^-128.
template <rounding Rounding>
constexpr int128 interval_hyperbolic_tangent(const real_operand& x, int fraction_bits) noexcept {
  if (x.whole() >= 64) {
    return beside<Rounding>(with_sign(int128{1} << fraction_bits, x.is_negative), x.is_negative);
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval power = exponential_interval<exponential_base::e>(x.with(digits).scaled(1));
    const interval one = whole_like(power, 1);
    return (power - one) / (power + one);
  });
}

/// asinh(x) = log(|x| + sqrt(x^2 + 1)) with the sign of x; acosh(x) = log(x + sqrt(x^2 - 1)).
/// @pre x >= 1 for acosh
template <hyperbola Function, rounding Rounding>
constexpr int128 interval_inverse_hyperbolic(const real_operand& x, int fraction_bits) noexcept {
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval operand = x.absolute().with(digits);
    const interval one = whole_like(operand, 1);
    const interval square =
        Function == hyperbola::sine ? operand * operand + one : (operand - one) * (operand + one);
    return with_sign(natural_logarithm(operand + sqrt(square)), x.is_negative);
  });
}

/// atanh(x) = log((1 + x) / (1 - x)) / 2. @pre |x| < 1
template <rounding Rounding>
constexpr int128 interval_inverse_hyperbolic_tangent(const real_operand& x,
                                                     int fraction_bits) noexcept {
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval operand = x.with(digits);
    const interval one = whole_like(operand, 1);
    return natural_logarithm((one + operand) / (one - operand)).scaled(-1);
  });
}

/// \}

/// @name Functions of angles
/// \{

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
  std::uint64_t quarters;
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
    const std::uint64_t degrees = (x.whole() % 360 + 90 * ahead) % 360;
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

/// \}

/// @name Roots and powers
/// \{

/// The cube root. No tie: the cube of an odd number of half ulps is no multiple of 1/4. The cube of
/// the nearest one differs by at least 1/8 from that of the root, in ulps, so 320 bits decide.
template <rounding Rounding>
constexpr int128 interval_cube_root(const real_operand& x, int fraction_bits) noexcept {
  if (x.magnitude == 0) return int128{0};
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    return with_sign(power_of_two(binary_logarithm(x.absolute().with(digits)) / 3), x.is_negative);
  });
}

/// 1 / sqrt(x) for x > 0. The square of an odd number of half ulps has the reciprocal x in ulps
/// only if both are powers of two. The product of that square and x differs by at least 1/4 from
/// a power of two otherwise, so 320 bits decide.
template <rounding Rounding>
constexpr int128 interval_reciprocal_root(const real_operand& x, int fraction_bits) noexcept {
  // 1 / sqrt(2^(2 f + 2)) is 2^-(f + 1).
  const int exponent = 2 * fraction_bits + 2 + x.places;
  if (exponent < 64 && x.magnitude == std::uint64_t{1} << exponent) {
    return shift_right<Rounding>(int128{1}, 1);
  }
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval root = sqrt(x.with(digits));
    return whole_like(root, 1) / root;
  });
}

/// The root of a square; 0 if it is none.
constexpr std::uint64_t exact_root(std::uint64_t square) noexcept {
  const auto root = static_cast<std::uint64_t>(nearest_sqrt_of_word(square));
  return root >> 32 == 0 && root * root == square ? root : 0;
}

/// An odd number of half ulps that is a power; 0 if the power is not one, or is above 2^66.
///
/// Let |x| = odd 2^n and y = p / q in lowest terms, where q is a power of two. A rational power has
/// an integer r with r^q = odd, and q divides n. The power is then r^p 2^(n p / q), with an odd
/// r^p, so it is an odd number of half ulps only if n p / q = -(f + 1).
constexpr int128 odd_half_ulps(const real_operand& x, const real_operand& y,
                               int fraction_bits) noexcept {
  if (x.magnitude == 0 || y.magnitude == 0) return int128{0};
  const int twos = trailing_zeros(x.magnitude);
  std::uint64_t root = x.magnitude >> twos;
  int exponent = twos - x.places;
  const int shared = trailing_zeros(y.magnitude);
  for (int q = y.places; q > shared; --q) {
    if (exponent % 2 != 0) return int128{0};
    exponent /= 2;
    root = exact_root(root);
    if (root == 0) return int128{0};
    if (root == 1 && exponent == 0) return int128{0};  // x is 1
  }
  // p is the rest of y, with the twos that q does not take.
  const int more = shared > y.places ? shared - y.places : 0;
  const std::uint64_t odd = y.magnitude >> shared;
  // |exponent| is at most 64, so a p above 65 is far from -(f + 1).
  if (exponent == 0 || more > 6 || odd > 65) return int128{0};
  const int p = static_cast<int>(odd) << more;
  if (p > 65 || (y.is_negative ? -exponent : exponent) * p != -(fraction_bits + 1)) {
    return int128{0};
  }
  if (root == 1) return int128{1};
  if (y.is_negative) return int128{0};
  int128 power{1};
  for (int i = 0; i < p; ++i) {
    if ((power >> 66) != int128{0} || root >> 33 != 0) return p == 1 ? int128{root} : int128{0};
    power = power * int128{root};
  }
  return power;
}

/// x^y for x > 0, or for x < 0 and a whole y.
template <rounding Rounding>
constexpr int128 interval_power(const real_operand& x, const real_operand& y,
                                int fraction_bits) noexcept {
  // An odd whole number: its last bit is in the format.
  const bool is_odd = y.places < 64 && (y.magnitude >> y.places & 1) != 0;
  const bool is_negative = x.is_negative && is_odd;
  if (y.magnitude == 0 || x.is_one()) {
    return with_sign(int128{1} << fraction_bits, is_negative);
  }
  const int128 half_ulps = odd_half_ulps(x, y, fraction_bits);
  if (half_ulps != int128{0}) return shift_right<Rounding>(with_sign(half_ulps, is_negative), 1);
  return certain_ulps<Rounding>(fraction_bits, [&](std::size_t digits) {
    const interval exponent = y.with(digits) * binary_logarithm(x.absolute().with(digits));
    // From 2^8 on, the power is at least 2^256 or at most 2^-256.
    const interval power = exponent.exponent() > 8
                               ? whole_like(exponent, 1).scaled(exponent.is_negative() ? -256 : 256)
                               : power_of_two(exponent);
    return with_sign(power, is_negative);
  });
}

/// \}

}  // namespace fixproof::detail
