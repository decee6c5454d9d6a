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

/// x rounded to an integer by rule R, as std::int32_t for numbers of at most 32 bits and as
/// std::int64_t for wider ones. In unsigned formats of 32 and 64 bits, results from 2^31 and 2^63
/// on are out of range and wrap.
///
///     static_assert(to_integer<rounding::half_up>(q16_16(-1.5)) == -1);
///     static_assert(to_integer<rounding::half_away>(q16_16(-1.5)) == -2);
template <rounding R, class Raw, int F, policy P>
[[nodiscard]] constexpr auto to_integer(number<Raw, F, P> x) noexcept {
  using wide = detail::signed_t<detail::signed_bits<Raw> + 1>;
  using result = detail::signed_t<detail::bits_of<Raw>>;
  return static_cast<result>(detail::shift_right<R>(wide{x.raw()}, F));
}

namespace detail {

/// x rounded to a whole number by rule R. The policy handles overflow.
template <rounding R, class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> whole(
    number<Raw, F, P> x, const char* operation) noexcept(number<Raw, F, P>::never_throws) {
  using wide = signed_t<signed_bits<Raw> + 2>;
  return number<Raw, F, P>::from_raw(narrow<P.range, Raw>(
      shift_right<R>(wide{x.raw()}, F) << F, [&] { raise_overflow<F>(operation, x.raw()); }));
}

}  // namespace detail

/// The greatest whole number not above x.
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> floor(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return detail::whole<rounding::floor>(x, "floor");
}

/// The least whole number not below x. The policy handles overflow, which occurs above the highest
/// whole number.
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> ceil(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  // The floor of the negative, negated.
  using wide = detail::signed_t<detail::signed_bits<Raw> + 2>;
  const wide units = -(-wide{x.raw()} >> F << F);
  return number<Raw, F, P>::from_raw(
      detail::narrow<P.range, Raw>(units, [&] { detail::raise_overflow<F>("ceil", x.raw()); }));
}

/// The nearest whole number. If the policy rounds products to nearest, ties follow that rule;
/// otherwise they go up. The policy handles overflow, which occurs above the highest whole number.
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P>(round)(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  constexpr rounding rule = detail::is_to_nearest<P.multiply> ? P.multiply : rounding::half_up;
  return detail::whole<rule>(x, "round");
}

/// x truncated toward zero.
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> trunc(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return detail::whole<rounding::truncate>(x, "trunc");
}

/// The absolute value. That of the lowest number overflows; the policy handles it.
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P>(abs)(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  return number<Raw, F, P>::from_raw(detail::narrow<P.range, Raw>(
      detail::exact_magnitude(x.raw()), [&] { detail::raise_overflow<F>("abs", x.raw()); }));
}

/// The smaller of a and b.
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P>(min)(number<Raw, F, P> a, number<Raw, F, P> b) noexcept {
  return b < a ? b : a;
}

/// The larger of a and b.
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P>(max)(number<Raw, F, P> a, number<Raw, F, P> b) noexcept {
  return a < b ? b : a;
}

/// The number nearest to the square root, under every policy; there are no ties. The root of a
/// negative number is 0; under overflow::trap it throws domain_error. Only in signed formats
/// without a whole bit are some roots out of range. They throw an overflow_error under
/// overflow::trap, and saturate under every other policy.
///
///     static_assert(sqrt(q16_16(2)).raw() == 92682 && sqrt(q16_16(-1)) == q16_16());  // 92681.9
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> sqrt(number<Raw, F, P> x) noexcept(
    number<Raw, F, P>::never_throws) {
  if constexpr (P.range == overflow::trap) {
    if (x.raw() < 0) {
      detail::raise<domain_error>("domain error", "sqrt", detail::operand<Raw, F>{x.raw()});
    }
  }
  const Raw positive = x.raw() < 0 ? Raw{0} : x.raw();
  constexpr overflow range =
      detail::has_every_root<Raw, F> ? overflow::wrap : detail::function_range<P.range>;
  return number<Raw, F, P>::from_raw(detail::narrow<range, Raw>(
      detail::nearest_root<F>(positive), [&] { detail::raise_overflow<F>("sqrt", x.raw()); }));
}

/// a * b + c, rounded once by policy::multiply. The policy handles overflow.
///
///     static_assert(mul_add(q16_16(200), q16_16(200), q16_16(-30000)) == q16_16(10000));
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> mul_add(
    number<Raw, F, P> a, number<Raw, F, P> b,
    number<Raw, F, P> c) noexcept(number<Raw, F, P>::multiply_never_throws) {
  return number<Raw, F, P>::from_raw(detail::narrow<P.product_range(), Raw>(
      detail::rounded_mul_add<F, P.multiply>(a.raw(), b.raw(), c.raw()),
      [&] { detail::raise_overflow<F>("mul_add", a.raw(), b.raw(), c.raw()); }));
}

/// a + (b - a) * t, rounded once by policy::multiply: a at t = 0, b at t = 1, and extrapolated
/// outside 0 to 1. The policy handles overflow.
///
///     static_assert(lerp(q16_16(-32768), q16_16(32767), q16_16(0.5)) == q16_16(-0.5));
template <class Raw, int F, policy P>
[[nodiscard]] constexpr number<Raw, F, P> lerp(
    number<Raw, F, P> a, number<Raw, F, P> b,
    number<Raw, F, P> t) noexcept(number<Raw, F, P>::never_throws) {
  // The difference has one bit more than Raw. Half a unit does not fit beside the largest product
  // if every bit is after the point.
  constexpr int spare = !std::is_signed_v<Raw> ? 2 : F < detail::bits_of<Raw> ? 0 : 1;
  // Adding `a` to the product could overflow. Adding it after rounding is equivalent if the
  // rounding uses the sign and the parity of the sum.
  using wide = detail::signed_t<2 * detail::bits_of<Raw> + spare>;
  const wide start{a.raw()};
  const wide product = (wide{b.raw()} - start) * wide{t.raw()};
  const wide floor = start + (product >> F);
  wide rounded = floor;
  if constexpr (F > 0) {
    const bool odd = P.multiply == rounding::half_even && detail::is_odd(floor);
    rounded =
        start + ((product + detail::bias<P.multiply>(floor < wide{0}, odd, wide{1} << F)) >> F);
  }
  return number<Raw, F, P>::from_raw(detail::narrow<P.range, Raw>(
      rounded, [&] { detail::raise_overflow<F>("lerp", a.raw(), b.raw(), t.raw()); }));
}

namespace detail {

template <class T>
inline constexpr bool is_number = is_plain_number<T>;

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
template <class Raw, int F>
inline constexpr bool has_wide_sum = std::is_signed_v<Raw>&& bits_of<Raw> <= 32 && F > 0;

/// Whether the result depends only on the lower 64 bits of a sum of products.
template <class N>
inline constexpr bool rounds_modulo =
    has_wide_sum<typename N::raw_type, N::fraction_bits>&& N::rules
        .product_range() == overflow::wrap&& rounds_by_floor<N::rules.multiply>;

/// Rounds a sum of products that is known modulo 2^64.
template <class N>
requires rounds_modulo<N>
constexpr N rounded_sum(std::uint64_t sum) noexcept {
  constexpr int F = N::fraction_bits;
  const auto half =
      static_cast<std::uint64_t>(bias<N::rules.multiply>(false, false, std::int64_t{1} << F));
  return N::from_raw(static_cast<typename N::raw_type>((sum + half) >> F));
}

/// Rounds a sum of products once. @param fail raises the error of a sum that is out of range
template <class N, class Fail>
constexpr N rounded_sum(wide_sum sum, Fail fail) noexcept(N::multiply_never_throws) {
  using raw = typename N::raw_type;
  constexpr int F = N::fraction_bits;
  constexpr overflow range = N::rules.product_range();
  const bool odd = N::rules.multiply == rounding::half_even && is_odd(sum.low_shifted_right(F));
  sum.add(bias<N::rules.multiply>(sum.negative(), odd, std::int64_t{1} << F));
  if constexpr (range == overflow::wrap) {
    return N::from_raw(static_cast<raw>(sum.low_shifted_right(F)));
  } else {
    return N::from_raw(narrow<range, raw>(sum.clamped_shifted_right(F), fail));
  }
}

}  // namespace detail

/// The sum of a[i] * b[i], exact until it is rounded once by policy::multiply. The shorter range
/// sets the length. An empty sum is 0. Only the final sum can overflow; the policy handles it.
///
///     constexpr q16_16 a[]{q16_16(300), q16_16(300)};
///     constexpr q16_16 b[]{q16_16(300), q16_16(-299)};
///     static_assert(dot(a, b) == q16_16(300));
template <detail::number_range A, detail::number_range B>
requires std::same_as<detail::element_t<A>, detail::element_t<B>>
[[nodiscard]] constexpr detail::element_t<A> dot(const A& a, const B& b) noexcept(
    detail::element_t<A>::multiply_never_throws) {
  using result = detail::element_t<A>;
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
template <class To, detail::number_range A, detail::number_range B>
requires detail::is_plain_number<To> && detail::is_plain_number<detail::element_t<A>> &&
    detail::is_plain_number<detail::element_t<B>>
[[nodiscard]] constexpr To dot(const A& a, const B& b) noexcept(To::multiply_never_throws) {
  using left = detail::element_t<A>;
  using right = detail::element_t<B>;
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
/// @endcond

}  // namespace fixproof
