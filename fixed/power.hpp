/// @file
/// Roots, reciprocals, lengths and powers, to nearest; docs/functions.md says what was compared.
///
/// Each result is the number nearest to the exact value, or a bound of it under policy::functions.
/// If the policy rounds products to nearest, ties follow that rule; otherwise they go up. A result
/// out of range throws an overflow_error under overflow::trap. Under every other policy it
/// saturates. reciprocal(), hypot() and sqrt<To>() take every format, the others only formats of at
/// most 32 bits.
#pragma once

#include <cstdint>
#include <limits>

#include "fixed/detail/interval_power.hpp"
#include "fixed/detail/limited.hpp"
#include "fixed/detail/operands.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/result.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/scaled_root.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/variant.hpp"
#include "fixed/number.hpp"

#if defined(FIXED_SMALL)
#include "fixed/detail/digit_power.hpp"
#else
#include "fixed/detail/power.hpp"
#endif

namespace fixproof {

namespace detail::FIXED_FUNCTIONS {

/// The root of a sum of squares.
template <class Number, class... Coordinates>
constexpr Number length(Coordinates... of) noexcept(Number::never_throws) {
  using raw = typename Number::raw_type;
  constexpr int bits = std::numeric_limits<raw>::digits;
  // The lowest number has the largest square, 4^bits. The sum of three squares is below 4^(bits +
  // 1).
  if constexpr (2 * bits + 2 <= 64) {
    const auto square = [](std::int64_t x) { return static_cast<std::uint64_t>(x * x); };
    return limited<Number>(rounded_sqrt_of_word<rounding_of<Number>>((square(of.raw()) + ...)),
                           "hypot", of...);
  } else {
    using wide = signed_t<2 * bits + 5>;
    const auto square = [](const wide& x) { return x * x; };
    const wide sum = (square(wide{of.raw()}) + ...);
    return limited<Number>(
        rounded_root<rounding_of<Number>>(nearest_sqrt_by_pairs<bits + 2>(sum), sum), "hypot",
        of...);
  }
}

/// The root of a sum of squares as a To. The numbers of the sum are brought to the
/// highest of their fraction bits.
template <class To, class... Coordinates>
constexpr To length_to(Coordinates... of) noexcept(To::never_throws) {
  constexpr int fraction = [] {
    int most = 0;
    ((most = larger(most, Coordinates::fraction_bits)), ...);
    return most;
  }();
  // The lowest number has the largest square, at most 4^bits. So three squares are below 4^(bits +
  // 1).
  constexpr int bits = [] {
    int most = 0;
    ((most = larger(most, std::numeric_limits<typename Coordinates::raw_type>::digits + fraction -
                              Coordinates::fraction_bits)),
     ...);
    return most;
  }();
  constexpr int sum_bits = 2 * bits + 2;
  constexpr int shift = 2 * (To::fraction_bits - fraction);
  using factor = signed_t<2 * bits + 2>;
  using wide =
      signed_t<larger(signed_bits<typename To::raw_type>, sum_bits + larger(shift, 1) + 4)>;
  const auto square = [](const factor& x) { return wide{x * x}; };
  const wide sum = (square(factor{of.raw()} << (fraction - Coordinates::fraction_bits)) + ...);
  return narrowed_to<To, function_range<To::rules.range>>(
      rounded_scaled_sqrt<rounding_of<To>, shift, sum_bits>(sum), "hypot", of...);
}

template <class Number>
constexpr bool is_whole(Number y) noexcept {
  if constexpr (needs_intervals<Number>) {
    return real_operand_of(y).is_whole();
  } else {
    return std::int64_t{y.raw()} % (std::int64_t{1} << Number::fraction_bits) == 0;
  }
}

/// The ulps of x^y for x < 0 and a whole y, or for x > 0.
template <class Number>
constexpr auto power_of(Number x, Number y) noexcept {
  if constexpr (needs_intervals<Number>) {
    return interval_power<rounding_of<Number>>(real_operand_of(x), real_operand_of(y),
                                               Number::fraction_bits);
  } else {
    constexpr int Point = Number::fraction_bits;
    const std::int64_t raw{x.raw()};
    const auto magnitude = static_cast<std::uint64_t>(raw < 0 ? -raw : raw);
    const bool is_odd_power = (std::int64_t{y.raw()} >> Point & 1) != 0;
    constexpr rounding ties = rounding_of<Number>;
    if (raw > 0 || !is_odd_power) return nearest_real_power<ties>(magnitude, y.raw(), Point);
    // A negative tie that goes up goes down in magnitude.
    constexpr bool is_up = ties == rounding::half_up;
    return -(is_up ? nearest_real_power<rounding::floor>(magnitude, y.raw(), Point)
                   : nearest_real_power<ties>(magnitude, y.raw(), Point));
  }
}

/// The ulps of the cube root.
template <class Number>
constexpr auto cube_root(Number x) noexcept {
  if constexpr (needs_intervals<Number>) {
    return interval_cube_root<rounding_of<Number>>(real_operand_of(x), Number::fraction_bits);
  } else {
    const std::int64_t raw{x.raw()};
    const std::int64_t root =
        nearest_cube_root(static_cast<std::uint64_t>(raw < 0 ? -raw : raw), Number::fraction_bits);
    return raw < 0 ? -root : root;
  }
}

/// The ulps of 1 / sqrt(x) for x > 0.
template <class Number>
constexpr auto reciprocal_root(Number x) noexcept {
  if constexpr (needs_intervals<Number>) {
    return interval_reciprocal_root<rounding_of<Number>>(real_operand_of(x), Number::fraction_bits);
  } else {
    return nearest_reciprocal_root<rounding_of<Number>>(static_cast<std::uint64_t>(x.raw()),
                                                        Number::fraction_bits);
  }
}

/// The ulps of 1 / x for an x that is not 0.
template <class Number>
constexpr auto reciprocal_of(Number x) noexcept {
  constexpr int Point = Number::fraction_bits;
  constexpr rounding rule = rounding_of<Number>;
  if constexpr (is_to_nearest<rule>) {
    return nearest_reciprocal<rule, Point>(x.raw());
  } else {
    using wide = signed_t<larger(2 * Point + 2, signed_bits<typename Number::raw_type> + 1)>;
    return rounded_ratio<rule>(wide{1} << (2 * Point), wide{x.raw()});
  }
}

}  // namespace detail::FIXED_FUNCTIONS

inline namespace FIXED_FUNCTIONS {

/// The cube root.
///
///     static_assert(cbrt(q16_16(-2)).raw() == -82570 && cbrt(q16_16(27)) == 3);  // -82570.2
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> cbrt(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::limited<number<Raw, Point, Rules>>(detail::FIXED_FUNCTIONS::cube_root(x), "cbrt",
                                                    x);
}

/// 1 / sqrt(x). For x <= 0 it throws a domain_error under overflow::trap, and is the highest number
/// under every other policy.
///
///     static_assert(rsqrt(q16_16(2)).raw() == 46341);  // 46340.95
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> rsqrt(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  if (x.raw() <= 0) {
    return detail::outside_domain<number<Raw, Point, Rules>>((std::numeric_limits<Raw>::max)(),
                                                             "rsqrt", x);
  }
  return detail::limited<number<Raw, Point, Rules>>(detail::FIXED_FUNCTIONS::reciprocal_root(x),
                                                    "rsqrt", x);
}

/// 1 / x, rounded as other functions. (Operator / rounds as policy::divide says.) For zero it
/// throws a domain_error under overflow::trap, and is the highest number under every other policy.
///
///     static_assert(reciprocal(q16_16(-3)).raw() == -21845);  // -21845.3
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> reciprocal(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  if (x.raw() == 0) {
    return detail::outside_domain<number<Raw, Point, Rules>>((std::numeric_limits<Raw>::max)(),
                                                             "reciprocal", x);
  }
  return detail::limited<number<Raw, Point, Rules>>(detail::FIXED_FUNCTIONS::reciprocal_of(x),
                                                    "reciprocal", x);
}

/// The length of the vector (x, y). There are no ties.
///
///     static_assert(hypot(q16_16(30000), q16_16(-3)).raw() == 1966080010);  // 1966080009.8
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> hypot(
    number<Raw, Point, Rules> x,
    number<Raw, Point, Rules> y) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::length<number<Raw, Point, Rules>>(x, y);
}

/// The length of the vector (x, y, z).
///
///     static_assert(hypot(q16_16(2), q16_16(3), q16_16(6)) == 7);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> hypot(
    number<Raw, Point, Rules> x, number<Raw, Point, Rules> y,
    number<Raw, Point, Rules> z) noexcept(number<Raw, Point, Rules>::never_throws) {
  return detail::FIXED_FUNCTIONS::length<number<Raw, Point, Rules>>(x, y, z);
}

/// The square root as a To: the To nearest to the exact root, for every x. If the policy of To
/// rounds products to nearest, ties follow that rule; otherwise they go up. The root of a negative
/// number is 0. A root out of range saturates. Under overflow::trap in the policy of To, the first
/// throws a domain_error and the second an overflow_error.
///
///     static_assert(sqrt<q2_30>(q16_16(2)).raw() == 1518500250);  // 1518500249.99
///     static_assert(sqrt<q16_16>(q32_0(2)).raw() == 92682);       // 92681.9
template <class To, class Raw, int Point, policy Rules>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To sqrt(number<Raw, Point, Rules> x) noexcept(To::never_throws) {
  constexpr overflow range = detail::function_range<To::rules.range>;
  if constexpr (range == overflow::trap) {
    if (x.raw() < 0) {
      detail::raise<domain_error>("domain error", "sqrt", detail::operand<Raw, Point>{x.raw()});
    }
  }
  constexpr int shift = 2 * To::fraction_bits - Point;
  constexpr int bits = std::numeric_limits<Raw>::digits;
  using wide = detail::signed_t<detail::larger(detail::signed_bits<typename To::raw_type>,
                                               bits + detail::larger(shift, 1) + 4)>;
  const Raw positive = x.raw() < 0 ? Raw{0} : x.raw();
  return detail::narrowed_to<To, range>(
      detail::rounded_scaled_sqrt<detail::rounding_of<To>, shift, bits>(wide{positive}), "sqrt", x);
}

/// The length of the vector (x, y) as a To: the To nearest to the exact length, for every x and y.
/// If the policy of To rounds products to nearest, ties follow that rule; otherwise they go up. A
/// length out of range throws an overflow_error under overflow::trap in the policy of To, and
/// saturates under every other policy.
///
///     static_assert(hypot<q2_30>(q1_31(-1), q1_31(-1)).raw() == 1518500250);  // 1518500249.99
///     static_assert(hypot<q16_16>(q24_8(-3), q2_30(1.25)) == q16_16(3.25));
template <class To, class RawA, int FA, policy PA, class RawB, int FB, policy PB>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To hypot(number<RawA, FA, PA> x,
                                 number<RawB, FB, PB> y) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::length_to<To>(x, y);
}

/// The length of the vector (x, y, z) as a To, as that of two numbers.
///
///     static_assert(hypot<q2_14>(q1_15(-0.5), q1_15(-0.5), q1_15(-0.5)).raw() == 14189);
template <class To, class RawA, int FA, policy PA, class RawB, int FB, policy PB, class RawC,
          int FC, policy PC>
requires detail::is_plain_number<To>
[[nodiscard]] constexpr To hypot(number<RawA, FA, PA> x, number<RawB, FB, PB> y,
                                 number<RawC, FC, PC> z) noexcept(To::never_throws) {
  return detail::FIXED_FUNCTIONS::length_to<To>(x, y, z);
}

/// x to the power of y; 1 if y is 0. For a negative x, y must be a whole number, and for x = 0 it
/// must not be negative. Outside this domain it throws a domain_error under overflow::trap. Under
/// every other policy, a power of 0 is then the highest number, and a power of a negative x is 0.
///
///     static_assert(pow(q16_16(3), q16_16(1.5)).raw() == 340535);  // 340535.05
///     static_assert(pow(q16_16(-2), q16_16(-3)) == q16_16(-0.125));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> pow(
    number<Raw, Point, Rules> x,
    number<Raw, Point, Rules> y) noexcept(number<Raw, Point, Rules>::never_throws) {
  using result = number<Raw, Point, Rules>;
  if (y.raw() != 0 && x.raw() == 0) {
    if (y.raw() > 0) return x;
    return detail::outside_domain<result>((std::numeric_limits<Raw>::max)(), "pow", x, y);
  }
  if (x.raw() < 0 && !detail::FIXED_FUNCTIONS::is_whole(y)) {
    return detail::outside_domain<result>(0, "pow", x, y);
  }
  return detail::limited<result>(detail::FIXED_FUNCTIONS::power_of(x, y), "pow", x, y);
}

/// @cond
FIXED_REFUSED_PLAIN(cbrt)
FIXED_REFUSED_PLAIN(rsqrt)
FIXED_REFUSED_PLAIN(reciprocal)
FIXED_REFUSED_MIX(hypot)
FIXED_REFUSED_MIX(pow)
/// @endcond

}  // namespace FIXED_FUNCTIONS
}  // namespace fixproof
