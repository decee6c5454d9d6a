/// @file
/// Mathematical functions: whole parts, absolute value, square root, and sums of products with one
/// rounding.
#pragma once

#include <array>  // std::data, std::size
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "fixed/detail/exact.hpp"
#include "fixed/detail/operands.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/result.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/wide_sum.hpp"
#include "fixed/number.hpp"

namespace fixproof {

/// x rounded to an integer by rule Rounding, as std::int32_t for numbers of at most 32 bits and as
/// std::int64_t for wider ones. In unsigned formats of 32 and 64 bits, results from 2^31 and 2^63
/// on are out of range and wrap.
///
///     static_assert(to_integer<rounding::half_up>(q16_16(-1.5)) == -1);
///     static_assert(to_integer<rounding::half_away>(q16_16(-1.5)) == -2);
template <rounding Rounding, class Raw, int Point, policy Rules>
[[nodiscard]] constexpr auto to_integer(number<Raw, Point, Rules> x) noexcept {
  using wide = detail::signed_t<detail::signed_bits<Raw> + 1>;
  using result = detail::signed_t<detail::bits_of<Raw>>;
  return static_cast<result>(detail::shift_right<Rounding>(wide{x.raw()}, Point));
}

namespace detail {

/// x rounded to a whole number by rule Rounding. The policy handles overflow.
template <rounding Rounding, class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> whole(
    number<Raw, Point, Rules> x,
    const char* operation) noexcept(number<Raw, Point, Rules>::never_throws) {
  using wide = signed_t<signed_bits<Raw> + 2>;
  return number<Raw, Point, Rules>::from_raw(
      narrow<Rules.range, Raw>(shift_right<Rounding>(wide{x.raw()}, Point) << Point,
                               [&] { raise_overflow<Point>(operation, x.raw()); }));
}

}  // namespace detail

/// The greatest whole number not above x.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> floor(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::whole<rounding::floor>(x, "floor");
}

/// The least whole number not below x. The policy handles overflow, which occurs above the highest
/// whole number.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> ceil(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  // The floor of the negative, negated.
  using wide = detail::signed_t<detail::signed_bits<Raw> + 2>;
  const wide units = -(-wide{x.raw()} >> Point << Point);
  return number<Raw, Point, Rules>::from_raw(detail::narrow<Rules.range, Raw>(
      units, [&] { detail::raise_overflow<Point>("ceil", x.raw()); }));
}

/// The nearest whole number. If the policy rounds products to nearest, ties follow that rule;
/// otherwise they go up. The policy handles overflow, which occurs above the highest whole number.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules>(round)(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  constexpr rounding rule =
      detail::is_to_nearest<Rules.multiply> ? Rules.multiply : rounding::half_up;
  return detail::whole<rule>(x, "round");
}

/// x truncated toward zero.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> trunc(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return detail::whole<rounding::truncate>(x, "trunc");
}

/// The absolute value. That of the lowest number overflows; the policy handles it.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules>(abs)(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  return number<Raw, Point, Rules>::from_raw(detail::narrow<Rules.range, Raw>(
      detail::exact_magnitude(x.raw()), [&] { detail::raise_overflow<Point>("abs", x.raw()); }));
}

/// The smaller of a and b.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules>(min)(number<Raw, Point, Rules> a,
                                                       number<Raw, Point, Rules> b) noexcept {
  return b < a ? b : a;
}

/// The larger of a and b.
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules>(max)(number<Raw, Point, Rules> a,
                                                       number<Raw, Point, Rules> b) noexcept {
  return a < b ? b : a;
}

/// The number from `low` to `high` that is nearest to x. It is `high` if `low` is the larger.
///
///     static_assert(clamp(q16_16(2.5), q16_16(-1), q16_16(1)) == 1);
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules>(clamp)(number<Raw, Point, Rules> x,
                                                         number<Raw, Point, Rules> low,
                                                         number<Raw, Point, Rules> high) noexcept {
  return (min)((max)(x, low), high);
}

/// The number nearest to the square root, or a bound of it under policy::functions. There are no
/// ties. The root of a negative number is 0; under overflow::trap it throws domain_error. Only in
/// signed formats without a whole bit are some roots out of range. They throw an overflow_error
/// under overflow::trap, and saturate under every other policy.
///
///     static_assert(sqrt(q16_16(2)).raw() == 92682 && sqrt(q16_16(-1)) == q16_16());  // 92681.9
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> sqrt(number<Raw, Point, Rules> x) noexcept(
    number<Raw, Point, Rules>::never_throws) {
  if constexpr (Rules.range == overflow::trap) {
    if (x.raw() < 0) {
      detail::raise<domain_error>("domain error", "sqrt", detail::operand<Raw, Point>{x.raw()});
    }
  }
  const Raw positive = x < number<Raw, Point, Rules>() ? Raw{0} : x.raw();
  // Only an upper bound of a root can be 1 in a format without a whole bit.
  constexpr bool is_in_range =
      detail::has_every_root<Raw, Point> && Rules.functions != rounding::ceiling;
  constexpr overflow range = is_in_range ? overflow::wrap : detail::function_range<Rules.range>;
  return number<Raw, Point, Rules>::from_raw(
      detail::narrow<range, Raw>(detail::stored_root<Rules.functions, Point>(positive),
                                 [&] { detail::raise_overflow<Point>("sqrt", x.raw()); }));
}

/// a * b + c, rounded once by policy::multiply. The policy handles overflow.
///
///     static_assert(mul_add(q16_16(200), q16_16(200), q16_16(-30000)) == q16_16(10000));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> mul_add(
    number<Raw, Point, Rules> a, number<Raw, Point, Rules> b,
    number<Raw, Point, Rules> c) noexcept(number<Raw, Point, Rules>::multiply_never_throws) {
  return number<Raw, Point, Rules>::from_raw(detail::narrow<Rules.product_range(), Raw>(
      detail::rounded_mul_add<Point, Rules.multiply>(a.raw(), b.raw(), c.raw()),
      [&] { detail::raise_overflow<Point>("mul_add", a.raw(), b.raw(), c.raw()); }));
}

/// a + (b - a) * t, rounded once by policy::multiply: a at t = 0, b at t = 1, and extrapolated
/// outside 0 to 1. The policy handles overflow.
///
///     static_assert(lerp(q16_16(-32768), q16_16(32767), q16_16(0.5)) == q16_16(-0.5));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> lerp(
    number<Raw, Point, Rules> a, number<Raw, Point, Rules> b,
    number<Raw, Point, Rules> t) noexcept(number<Raw, Point, Rules>::never_throws) {
  // The difference has one bit more than Raw. Half a unit does not fit beside the largest product
  // if every bit is after the point.
  constexpr int spare = !std::is_signed_v<Raw> ? 2 : Point < detail::bits_of<Raw> ? 0 : 1;
  // Adding `a` to the product could overflow. Adding it after rounding is equivalent if the
  // rounding uses the sign and the parity of the sum.
  using wide = detail::signed_t<2 * detail::bits_of<Raw> + spare>;
  const wide start{a.raw()};
  const wide product = (wide{b.raw()} - start) * wide{t.raw()};
  const wide floor = start + (product >> Point);
  wide rounded = floor;
  if constexpr (Point > 0) {
    const bool odd = Rules.multiply == rounding::half_even && detail::is_odd(floor);
    rounded =
        start +
        ((product + detail::bias<Rules.multiply>(floor < wide{0}, odd, wide{1} << Point)) >> Point);
  }
  return number<Raw, Point, Rules>::from_raw(detail::narrow<Rules.range, Raw>(
      rounded, [&] { detail::raise_overflow<Point>("lerp", a.raw(), b.raw(), t.raw()); }));
}

namespace detail {

template <class Type>
inline constexpr bool is_number = is_plain_number<Type>;

/// The element type of a range with std::data().
template <class Range>
using element_t = std::remove_cvref_t<decltype(*std::data(std::declval<const Range&>()))>;

template <class Range>
concept sized = requires(const Range& range) {
  std::size(range);
};

/// An array, vector, span or similar range of numbers. Does not use <ranges>, which compiles slowly
/// and is missing from some freestanding libraries.
template <class Range>
concept number_range = is_number<element_t<Range>> && sized<Range>;

/// Whether 128-bit sums of products are kept in a wide_sum.
template <class Raw, int Point>
inline constexpr bool has_wide_sum = std::is_signed_v<Raw>&& bits_of<Raw> <= 32 && Point > 0;

/// Whether the result depends only on the lower 64 bits of a sum of products.
template <class Number>
inline constexpr bool rounds_modulo =
    has_wide_sum<typename Number::raw_type, Number::fraction_bits>&& Number::rules
        .product_range() == overflow::wrap&& rounds_by_floor<Number::rules.multiply>;

/// Rounds a sum of products that is known modulo 2^64.
template <class Number>
requires rounds_modulo<Number>
constexpr Number rounded_sum(std::uint64_t sum) noexcept {
  constexpr int Point = Number::fraction_bits;
  const auto half = static_cast<std::uint64_t>(
      bias<Number::rules.multiply>(false, false, std::int64_t{1} << Point));
  return Number::from_raw(static_cast<typename Number::raw_type>((sum + half) >> Point));
}

/// Rounds a sum of products once. @param fail raises the error of a sum that is out of range
template <class Number, class Fail>
constexpr Number rounded_sum(wide_sum sum, Fail fail) noexcept(Number::multiply_never_throws) {
  using raw = typename Number::raw_type;
  constexpr int Point = Number::fraction_bits;
  constexpr overflow range = Number::rules.product_range();
  const bool odd =
      Number::rules.multiply == rounding::half_even && is_odd(sum.low_shifted_right(Point));
  sum.add(bias<Number::rules.multiply>(sum.negative(), odd, std::int64_t{1} << Point));
  if constexpr (range == overflow::wrap) {
    return Number::from_raw(static_cast<raw>(sum.low_shifted_right(Point)));
  } else {
    return Number::from_raw(narrow<range, raw>(sum.clamped_shifted_right(Point), fail));
  }
}

}  // namespace detail

/// The sum of a[i] * b[i], exact until it is rounded once by policy::multiply. The shorter range
/// sets the length. An empty sum is 0. Only the final sum can overflow; the policy handles it.
///
///     constexpr q16_16 a[]{q16_16(300), q16_16(300)};
///     constexpr q16_16 b[]{q16_16(300), q16_16(-299)};
///     static_assert(dot(a, b) == q16_16(300));
template <detail::number_range First, detail::number_range Second>
requires std::same_as<detail::element_t<First>, detail::element_t<Second>>
[[nodiscard]] constexpr detail::element_t<First> dot(const First& a, const Second& b) noexcept(
    detail::element_t<First>::multiply_never_throws) {
  using result = detail::element_t<First>;
  using raw = typename result::raw_type;
  constexpr policy rules = result::rules;
  constexpr int bits = result::fraction_bits;
  using product = detail::term_t<raw, raw, std::int64_t>;

  const auto* x = std::data(a);
  const auto* y = std::data(b);
  const std::size_t terms = std::size(a) < std::size(b) ? std::size(a) : std::size(b);
  [[maybe_unused]] const auto fail = [terms] {
    detail::raise<overflow_error>("overflow", "dot", detail::term_count{terms});
  };

  if constexpr (detail::rounds_modulo<result>) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < terms; ++i) {
      sum += static_cast<std::uint64_t>(product{x[i].raw()} * product{y[i].raw()});
    }
    return detail::rounded_sum<result>(sum);
  } else if constexpr (detail::has_wide_sum<raw, bits>) {
    detail::wide_sum sum;
    for (std::size_t i = 0; i < terms; ++i) sum.add(product{x[i].raw()} * product{y[i].raw()});
    return detail::rounded_sum<result>(sum, fail);
  } else {
    using wide = detail::wide_integer<3>;
    wide sum;
    for (std::size_t i = 0; i < terms; ++i) sum = sum + wide{x[i].raw()} * wide{y[i].raw()};
    return result::from_raw(detail::narrow<rules.product_range(), raw>(
        detail::shift_right<rules.multiply>(sum, bits), fail));
  }
}

/// The sum of a[i] * b[i] as a To, exact until it is rounded once by policy::multiply of To. The
/// ranges may have numbers of two formats. The shorter range sets the length. Only the final sum
/// can overflow; the policy of To handles it, as for products.
///
///     constexpr q1_31 a[]{q1_31(-1), q1_31(0.5)};
///     constexpr q16_16 b[]{q16_16(-300), q16_16(-299)};
///     static_assert(dot<q32_32>(a, b) == q32_32(150.5));
template <class To, detail::number_range First, detail::number_range Second>
requires detail::is_plain_number<To> && detail::is_plain_number<detail::element_t<First>> &&
    detail::is_plain_number<detail::element_t<Second>>
[[nodiscard]] constexpr To dot(const First& a,
                               const Second& b) noexcept(To::multiply_never_throws) {
  using left = detail::element_t<First>;
  using right = detail::element_t<Second>;
  constexpr int product_bits =
      detail::signed_bits<typename left::raw_type> + detail::signed_bits<typename right::raw_type>;
  // No range has 2^62 terms. Each is at most 2^(product_bits - 2).
  constexpr int bits = product_bits + 62;
  using wide = detail::signed_t<bits>;
  using product = detail::term_t<typename left::raw_type, typename right::raw_type, wide>;

  const auto* x = std::data(a);
  const auto* y = std::data(b);
  const std::size_t terms = std::size(a) < std::size(b) ? std::size(a) : std::size(b);
  wide sum{0};
  for (std::size_t i = 0; i < terms; ++i) {
    sum += product{x[i].raw()} * product{y[i].raw()};
  }
  return To::from_raw(detail::narrow<To::rules.product_range(), typename To::raw_type>(
      detail::rescaled<To, left::fraction_bits + right::fraction_bits, bits>(sum),
      [terms] { detail::raise<overflow_error>("overflow", "dot", detail::term_count{terms}); }));
}

/// @cond
FIXED_REFUSED_PLAIN(sqrt)
FIXED_REFUSED_MIX(mul_add)
FIXED_REFUSED_MIX(lerp)
FIXED_REFUSED_MIX(clamp)
/// @endcond

}  // namespace fixproof
