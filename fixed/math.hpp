/// \file
/// Mathematical functions: whole parts, absolute value, square root, and sums of products with one
/// rounding.
#pragma once

#include <array>  // std::data, std::size
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "fixed/detail/raise.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/wide_sum.hpp"
#include "fixed/number.hpp"

namespace fixproof {

/// x rounded to an integer by rule R. Always in range.
///
///     static_assert(to_integer<rounding::half_up>(q16_16(-1.5)) == -1);
///     static_assert(to_integer<rounding::half_away>(q16_16(-1.5)) == -2);
template <rounding R, int F, policy P>
constexpr std::int32_t to_integer(number<F, P> x) noexcept {
  return static_cast<std::int32_t>(detail::shift_right<R>(std::int64_t{x.raw()}, F));
}

namespace detail {

/// x rounded to a whole number by rule R. The policy handles overflow.
template <rounding R, int F, policy P>
constexpr number<F, P> whole(number<F, P> x,
                             const char* operation) noexcept(number<F, P>::never_throws) {
  const std::int64_t units = std::int64_t{to_integer<R>(x)} * (std::int64_t{1} << F);
  return number<F, P>::from_raw(
      narrow<P.range, raw_t<F>>(units, [&] { raise_overflow<F>(operation, x.raw()); }));
}

}  // namespace detail

/// The greatest whole number not above x.
template <int F, policy P>
constexpr number<F, P> floor(number<F, P> x) noexcept(number<F, P>::never_throws) {
  return detail::whole<rounding::floor>(x, "floor");
}

/// The least whole number not below x. The policy handles overflow, which occurs above the highest
/// whole number.
template <int F, policy P>
constexpr number<F, P> ceil(number<F, P> x) noexcept(number<F, P>::never_throws) {
  const bool whole = floor(x) == x;
  const std::int64_t units =
      (std::int64_t{to_integer<rounding::floor>(x)} + (whole ? 0 : 1)) * (std::int64_t{1} << F);
  return number<F, P>::from_raw(detail::narrow<P.range, detail::raw_t<F>>(
      units, [&] { detail::raise_overflow<F>("ceil", x.raw()); }));
}

/// The nearest whole number. Ties go away from zero if the policy rounds products half away from
/// zero, and up otherwise. The policy handles overflow, which occurs above the highest whole
/// number.
template <int F, policy P>
constexpr number<F, P>(round)(number<F, P> x) noexcept(number<F, P>::never_throws) {
  constexpr rounding rule =
      P.multiply == rounding::half_away ? rounding::half_away : rounding::half_up;
  return detail::whole<rule>(x, "round");
}

/// x truncated toward zero.
template <int F, policy P>
constexpr number<F, P> trunc(number<F, P> x) noexcept(number<F, P>::never_throws) {
  return detail::whole<rounding::truncate>(x, "trunc");
}

/// The absolute value. That of the lowest number overflows; the policy handles it.
template <int F, policy P>
constexpr number<F, P>(abs)(number<F, P> x) noexcept(number<F, P>::never_throws) {
  const std::int64_t raw = x.raw();
  return number<F, P>::from_raw(detail::narrow<P.range, detail::raw_t<F>>(
      raw < 0 ? -raw : raw, [&] { detail::raise_overflow<F>("abs", x.raw()); }));
}

/// The smaller of a and b.
template <int F, policy P>
constexpr number<F, P>(min)(number<F, P> a, number<F, P> b) noexcept {
  return b < a ? b : a;
}

/// The larger of a and b.
template <int F, policy P>
constexpr number<F, P>(max)(number<F, P> a, number<F, P> b) noexcept {
  return a < b ? b : a;
}

/// The number nearest to the square root, under every policy; there are no ties. The root of a
/// negative number is 0; under overflow::trap it throws domain_error.
///
///     static_assert(sqrt(q16_16(2)).raw() == 92682 && sqrt(q16_16(-1)) == q16_16());  // 92681.9
template <int F, policy P>
constexpr number<F, P> sqrt(number<F, P> x) noexcept(number<F, P>::never_throws) {
  if (x.raw() < 0) {
    if constexpr (P.range == overflow::trap) {
      detail::raise<domain_error>("domain error", "sqrt", detail::operand<F>{x.raw()});
    }
    return {};
  }
  return number<F, P>::from_raw(static_cast<detail::raw_t<F>>(
      detail::nearest_sqrt(std::int64_t{x.raw()} * (std::int64_t{1} << F))));
}

/// a * b + c, rounded once by policy::multiply. The policy handles overflow.
///
///     static_assert(mul_add(q16_16(200), q16_16(200), q16_16(-30000)) == q16_16(10000));
template <int F, policy P>
constexpr number<F, P> mul_add(number<F, P> a, number<F, P> b,
                               number<F, P> c) noexcept(number<F, P>::never_throws) {
  using wide = detail::wide_t<F>;
  const wide sum = wide{a.raw()} * wide{b.raw()} + wide{c.raw()} * (wide{1} << F);
  return number<F, P>::from_raw(detail::narrow<P.range, detail::raw_t<F>>(
      detail::shift_right<P.multiply>(sum, F),
      [&] { detail::raise_overflow<F>("mul_add", a.raw(), b.raw(), c.raw()); }));
}

/// a + (b - a) * t, rounded once by policy::multiply: a at t = 0, b at t = 1, and extrapolated for
/// other t. The policy handles overflow.
///
///     static_assert(lerp(q16_16(-32768), q16_16(32767), q16_16(0.5)) == q16_16(-0.5));
template <int F, policy P>
constexpr number<F, P> lerp(number<F, P> a, number<F, P> b,
                            number<F, P> t) noexcept(number<F, P>::never_throws) {
  // The product has 63 bits and a sign, so adding `a` could overflow. Adding `a` after rounding is
  // equivalent if the rounding uses the sign of the sum.
  const std::int64_t product = (std::int64_t{b.raw()} - a.raw()) * t.raw();
  const bool negative = a.raw() + (product >> F) < 0;
  const std::int64_t rounded =
      (product + detail::bias<P.multiply>(negative, std::int64_t{1} << F)) >> F;
  return number<F, P>::from_raw(detail::narrow<P.range, detail::raw_t<F>>(
      a.raw() + rounded, [&] { detail::raise_overflow<F>("lerp", a.raw(), b.raw(), t.raw()); }));
}

namespace detail {

template <class T>
inline constexpr bool is_number = false;
template <int F, policy P>
inline constexpr bool is_number<number<F, P>> = true;

/// The element type of a range with std::data().
template <class Range>
using element_t = std::remove_cvref_t<decltype(*std::data(std::declval<const Range&>()))>;

/// An array, vector, span or similar range of numbers. Does not use <ranges>, which compiles slowly
/// and is missing from some freestanding libraries.
template <class Range>
concept number_range = is_number<element_t<Range>> && requires(const Range& range) {
  std::size(range);
};

/// Whether the result depends only on the lower 64 bits of a sum of products.
template <policy P>
inline constexpr bool rounds_modulo = P.range == overflow::wrap&& rounds_by_floor<P.multiply>;

/// Rounds a sum of products that is known modulo 2^64.
template <int F, policy P>
requires rounds_modulo<P>
constexpr number<F, P> rounded_sum(std::uint64_t sum) noexcept {
  const auto half = static_cast<std::uint64_t>(bias<P.multiply>(false, std::int64_t{1} << F));
  return number<F, P>::from_raw(static_cast<raw_t<F>>((sum + half) >> F));
}

/// Rounds a sum of products once. \param terms the number of terms, for the text of an error
template <int F, policy P>
constexpr number<F, P> rounded_sum(wide_sum sum,
                                   std::size_t terms) noexcept(number<F, P>::never_throws) {
  sum.add(bias<P.multiply>(sum.negative(), std::int64_t{1} << F));
  if constexpr (P.range == overflow::wrap) {
    return number<F, P>::from_raw(static_cast<raw_t<F>>(sum.low_shifted_right(F)));
  } else {
    return number<F, P>::from_raw(narrow<P.range, raw_t<F>>(sum.clamped_shifted_right(F), [terms] {
      raise<overflow_error>("overflow", "dot", term_count{terms});
    }));
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
constexpr detail::element_t<A> dot(const A& a,
                                   const B& b) noexcept(detail::element_t<A>::never_throws) {
  using result = detail::element_t<A>;
  constexpr policy rules = result::rules;
  constexpr int bits = result::fraction_bits;

  const auto* x = std::data(a);
  const auto* y = std::data(b);
  const std::size_t terms = std::size(a) < std::size(b) ? std::size(a) : std::size(b);
  const auto product = [x, y](std::size_t i) { return std::int64_t{x[i].raw()} * y[i].raw(); };

  if constexpr (detail::rounds_modulo<rules>) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < terms; ++i) sum += static_cast<std::uint64_t>(product(i));
    return detail::rounded_sum<bits, rules>(sum);
  } else {
    detail::wide_sum sum;
    for (std::size_t i = 0; i < terms; ++i) sum.add(product(i));
    return detail::rounded_sum<bits, rules>(sum, terms);
  }
}

}  // namespace fixproof
