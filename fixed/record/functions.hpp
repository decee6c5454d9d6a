/// @file
/// The functions of plain numbers for recorded numbers.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "fixed/bytes.hpp"
#include "fixed/fixed.hpp"
#include "fixed/record/number.hpp"

namespace fixproof {

/// @cond
// NOLINTBEGIN(cppcoreguidelines-macro-usage,bugprone-macro-parentheses): defines functions
#define FIXPROOF_RECORDED_1(name, kind_name)                                               \
  template <class Number>                                                                  \
  requires requires(Number x) { fixproof::name(x); }                                       \
  [[nodiscard]] constexpr recorded_number<Number>(name)(                                   \
      recorded_number<Number> x,                                                           \
      record::place from = FIXPROOF_HERE) noexcept(noexcept((fixproof::name)(Number()))) { \
    return record::detail::logged<record::kind::kind_name, Number>(                        \
        from, [](Number a) { return (fixproof::name)(a); }, x.value_);                     \
  }
#define FIXPROOF_RECORDED_2(name, kind_name)                                                  \
  template <class Number>                                                                     \
  requires requires(Number x) { (fixproof::name)(x, x); }                                     \
  [[nodiscard]] constexpr recorded_number<Number>(name)(                                      \
      recorded_number<Number> x, std::type_identity_t<recorded_number<Number>> y,             \
      record::place from =                                                                    \
          FIXPROOF_HERE) noexcept(noexcept((fixproof::name)(Number(), Number()))) {           \
    return record::detail::logged<record::kind::kind_name, Number>(                           \
        from, [](Number a, Number b) { return (fixproof::name)(a, b); }, x.value_, y.value_); \
  }
#define FIXPROOF_RECORDED_3(name, kind_name)                                                  \
  template <class Number>                                                                     \
  [[nodiscard]] constexpr recorded_number<Number> name(                                       \
      recorded_number<Number> x, std::type_identity_t<recorded_number<Number>> y,             \
      std::type_identity_t<recorded_number<Number>> z,                                        \
      record::place from =                                                                    \
          FIXPROOF_HERE) noexcept(noexcept(fixproof::name(Number(), Number(), Number()))) {   \
    return record::detail::logged<record::kind::kind_name, Number>(                           \
        from, [](Number a, Number b, Number c) { return fixproof::name(a, b, c); }, x.value_, \
        y.value_, z.value_);                                                                  \
  }
// After `using std::max;`, a call with two recorded numbers prefers this to std::max, because it is
// more specialised.
#define FIXPROOF_RECORDED_PAIR(name)                                                          \
  template <class Number>                                                                     \
  [[nodiscard]] constexpr recorded_number<Number>(name)(                                      \
      recorded_number<Number> x, recorded_number<Number> y,                                   \
      record::place from = FIXPROOF_HERE) noexcept {                                          \
    return record::detail::logged<record::kind::name, Number>(                                \
        from, [](Number a, Number b) { return (fixproof::name)(a, b); }, x.value_, y.value_); \
  }
// NOLINTEND(cppcoreguidelines-macro-usage,bugprone-macro-parentheses)

FIXPROOF_RECORDED_1(floor, floor)
FIXPROOF_RECORDED_1(ceil, ceil)
FIXPROOF_RECORDED_1(round, round)
FIXPROOF_RECORDED_1(trunc, trunc)
FIXPROOF_RECORDED_1(abs, abs)
FIXPROOF_RECORDED_2(min, min)
FIXPROOF_RECORDED_2(max, max)
FIXPROOF_RECORDED_PAIR(min)
FIXPROOF_RECORDED_PAIR(max)
FIXPROOF_RECORDED_1(sqrt, sqrt)
FIXPROOF_RECORDED_3(mul_add, mul_add)
FIXPROOF_RECORDED_3(lerp, lerp)
FIXPROOF_RECORDED_3(mul_div, mul_div)
FIXPROOF_RECORDED_2(fmod, fmod)
FIXPROOF_RECORDED_2(remainder, nearest_remainder)
FIXPROOF_RECORDED_1(rint, rint)
FIXPROOF_RECORDED_1(nearbyint, rint)
FIXPROOF_RECORDED_2(copysign, copysign)
FIXPROOF_RECORDED_2(nextafter, nextafter)
FIXPROOF_RECORDED_2(nexttoward, nextafter)
FIXPROOF_RECORDED_1(sin, sin)
FIXPROOF_RECORDED_1(cos, cos)
FIXPROOF_RECORDED_1(tan, tan)
FIXPROOF_RECORDED_1(sin_of_degrees, sin_of_degrees)
FIXPROOF_RECORDED_1(cos_of_degrees, cos_of_degrees)
FIXPROOF_RECORDED_1(tan_of_degrees, tan_of_degrees)
FIXPROOF_RECORDED_1(sin_of_turns, sin_of_turns)
FIXPROOF_RECORDED_1(cos_of_turns, cos_of_turns)
FIXPROOF_RECORDED_1(tan_of_turns, tan_of_turns)
FIXPROOF_RECORDED_1(exp, exp)
FIXPROOF_RECORDED_1(exp2, exp2)
FIXPROOF_RECORDED_1(expm1, expm1)
FIXPROOF_RECORDED_1(log, log)
FIXPROOF_RECORDED_1(log1p, log1p)
FIXPROOF_RECORDED_1(log2, log2)
FIXPROOF_RECORDED_1(log10, log10)
FIXPROOF_RECORDED_1(sinh, sinh)
FIXPROOF_RECORDED_1(cosh, cosh)
FIXPROOF_RECORDED_1(tanh, tanh)
FIXPROOF_RECORDED_1(cbrt, cbrt)
FIXPROOF_RECORDED_1(rsqrt, rsqrt)
FIXPROOF_RECORDED_1(reciprocal, reciprocal)
FIXPROOF_RECORDED_2(hypot, hypot)
FIXPROOF_RECORDED_3(hypot, hypot)
FIXPROOF_RECORDED_2(pow, pow)
FIXPROOF_RECORDED_1(atan, atan)
FIXPROOF_RECORDED_2(atan2, atan2)
FIXPROOF_RECORDED_1(asin, asin)
FIXPROOF_RECORDED_1(acos, acos)
#undef FIXPROOF_RECORDED_1
#undef FIXPROOF_RECORDED_2
#undef FIXPROOF_RECORDED_3
#undef FIXPROOF_RECORDED_PAIR
/// @endcond

/// As clamp() of plain numbers: recorded as max() and min().
template <class Number>
[[nodiscard]] constexpr recorded_number<Number>(clamp)(
    recorded_number<Number> x, std::type_identity_t<recorded_number<Number>> low,
    std::type_identity_t<recorded_number<Number>> high,
    record::place from = FIXPROOF_HERE) noexcept {
  return (min)((max)(x, low, from), high, from);
}

/// @name Functions with two results
/// \{

/// As those of plain numbers.
// NOLINTBEGIN(cppcoreguidelines-macro-usage): defines functions
#define FIXPROOF_RECORDED_SIN_COS(name)                                                    \
  template <class Number>                                                                  \
  [[nodiscard]] constexpr sin_and_cos<recorded_number<Number>> name(                       \
      recorded_number<Number> angle,                                                       \
      record::place from = FIXPROOF_HERE) noexcept(noexcept(fixproof::name(Number()))) {   \
    const sin_and_cos<Number> result = record::detail::logged<record::kind::name, Number>( \
        from, [](Number x) { return fixproof::name(x); }, angle.value_);                   \
    return {result.sin, result.cos};                                                       \
  }
FIXPROOF_RECORDED_SIN_COS(sin_cos)
FIXPROOF_RECORDED_SIN_COS(sin_cos_of_degrees)
FIXPROOF_RECORDED_SIN_COS(sin_cos_of_turns)
#undef FIXPROOF_RECORDED_SIN_COS
// NOLINTEND(cppcoreguidelines-macro-usage)
template <class Number>
requires std::is_signed_v<typename Number::raw_type>
[[nodiscard]] constexpr recorded_number<Number> remquo(
    recorded_number<Number> x, std::type_identity_t<recorded_number<Number>> y, int* quotient,
    record::place from = FIXPROOF_HERE) noexcept(Number::divide_never_throws) {
  const auto both = record::detail::logged<record::kind::remquo, Number>(
      from,
      [](Number a, Number b) {
        int whole = 0;
        const Number rest = fixproof::remquo(a, b, &whole);
        return std::pair<Number, int>(rest, whole);
      },
      x.value_, y.value_);
  *quotient = both.second;
  return both.first;
}
template <class Number>
[[nodiscard]] constexpr recorded_number<Number> modf(
    recorded_number<Number> x, recorded_number<Number>* whole,
    record::place from = FIXPROOF_HERE) noexcept(Number::never_throws) {
  const auto both = record::detail::logged<record::kind::modf, Number>(
      from,
      [](Number a) {
        Number part;
        const Number rest = fixproof::modf(a, &part);
        return std::pair<Number, Number>(rest, part);
      },
      x.value_);
  *whole = both.second;
  return both.first;
}
/// \}

/// @name Angles in tenths of a degree
/// \{

/// As those of plain numbers, which are templates that take any type, and so recorded ones. Of two
/// templates with the same parameters, the compiler takes the one with more constraints, which are
/// these. A parameter for the place would make the parameters differ.
template <class Recorded>
requires record::detail::is_recorded<Recorded>
[[nodiscard]] constexpr sin_and_cos<Recorded> sin_cos_of_tenths(std::integral auto angle) noexcept {
  using Number = typename Recorded::plain_type;
  const sin_and_cos<Number> result =
      record::detail::logged<record::kind::sin_cos_of_tenths, Number>(
          record::nowhere, [](auto x) { return fixproof::sin_cos_of_tenths<Number>(x); }, angle);
  return {result.sin, result.cos};
}
template <class Recorded>
requires record::detail::is_recorded<Recorded>
[[nodiscard]] constexpr Recorded cos_of_tenths(std::integral auto angle) noexcept {
  using Number = typename Recorded::plain_type;
  return record::detail::logged<record::kind::cos_of_tenths, Number>(
      record::nowhere, [](auto x) { return fixproof::cos_of_tenths<Number>(x); }, angle);
}
template <class Recorded>
requires record::detail::is_recorded<Recorded>
[[nodiscard]] constexpr Recorded sin_of_tenths(std::integral auto angle) noexcept {
  using Number = typename Recorded::plain_type;
  return record::detail::logged<record::kind::sin_of_tenths, Number>(
      record::nowhere, [](auto x) { return fixproof::sin_of_tenths<Number>(x); }, angle);
}
/// \}

/// As try_divide() of plain numbers: n / d, or nothing.
template <class Number>
[[nodiscard]] constexpr std::optional<recorded_number<Number>> try_divide(
    recorded_number<Number> n, std::type_identity_t<recorded_number<Number>> d,
    record::place from = FIXPROOF_HERE) noexcept {
  const std::optional<Number> result = record::detail::logged<record::kind::try_divide, Number>(
      from, [](Number a, Number b) { return fixproof::try_divide(a, b); }, n.value_, d.value_);
  return result ? std::optional<recorded_number<Number>>(*result) : std::nullopt;
}

/// Returns x rounded to an integer. It makes no number, so it is not recorded.
template <rounding Rule, class Number>
[[nodiscard]] constexpr auto to_integer(recorded_number<Number> x) noexcept {
  return fixproof::to_integer<Rule>(x.value_);
}

/// @name Signs and classes
/// \{

/// As those of plain numbers, and not recorded.
template <class Number>
[[nodiscard]] constexpr bool(signbit)(recorded_number<Number> x) noexcept {
  return (fixproof::signbit)(x.value_);
}
template <class Number>
[[nodiscard]] constexpr bool(isfinite)(recorded_number<Number> /*x*/) noexcept {
  return true;
}
template <class Number>
[[nodiscard]] constexpr bool(isinf)(recorded_number<Number> /*x*/) noexcept {
  return false;
}
template <class Number>
[[nodiscard]] constexpr bool(isnan)(recorded_number<Number> /*x*/) noexcept {
  return false;
}
template <class Number>
[[nodiscard]] constexpr bool(isnormal)(recorded_number<Number> x) noexcept {
  return (fixproof::isnormal)(x.value_);
}
/// \}

namespace record::detail {

/// Returns the sum of products of two ranges as a plain number Number. The record has the number of
/// terms and a hash of each range.
template <class Number, class First, class Second>
constexpr Number logged_dot(const First& a,
                            const Second& b) noexcept(Number::multiply_never_throws) {
  const std::size_t terms = std::size(a) < std::size(b) ? std::size(a) : std::size(b);
  const auto* const x = std::data(a);
  const auto* const y = std::data(b);
  const auto sum_of = [x, y](digest, digest, std::size_t count) {
    constexpr int fraction = fixproof::detail::element_t<First>::fraction_bits +
                             fixproof::detail::element_t<Second>::fraction_bits;
    using wide = fixproof::detail::wide_integer<3>;
    wide sum;
    for (std::size_t i = 0; i < count; ++i) sum = sum + wide{x[i].raw()} * wide{y[i].raw()};
    // 2^62 products of 64-bit integers have at most 191 bits, with the sign.
    return Number::from_raw(
        fixproof::detail::narrow<Number::rules.product_range(), typename Number::raw_type>(
            fixproof::detail::rescaled<Number, fraction, 191>(sum), [count] {
              fixproof::detail::raise<overflow_error>("overflow", "dot",
                                                      fixproof::detail::term_count{count});
            }));
  };
  const auto hash_of = [terms](const auto* numbers) {
    digest all{0};
    for (std::size_t i = 0; i < terms; ++i) {
      all.hash = next_hash(all.hash, i, bits_of(numbers[i].raw()));
    }
    return all;
  };
  return logged<kind::dot, Number>(nowhere, sum_of, hash_of(x), hash_of(y), terms);
}

}  // namespace record::detail

/// The sum of products of two ranges, as dot() of plain numbers. The record has the number of terms
/// and a hash of each range.
template <detail::number_range First, detail::number_range Second>
requires std::same_as<detail::element_t<First>, detail::element_t<Second>> &&
    record::detail::is_recorded<detail::element_t<First>>
[[nodiscard]] constexpr detail::element_t<First> dot(const First& a, const Second& b) noexcept(
    detail::element_t<First>::multiply_never_throws) {
  return record::detail::logged_dot<typename detail::element_t<First>::plain_type>(a, b);
}
/// The same as a To, as dot<To>() of plain numbers.
template <class To, detail::number_range First, detail::number_range Second>
requires record::detail::is_recorded<To> &&(record::detail::is_recorded<detail::element_t<First>> ||
                                            record::detail::is_recorded<detail::element_t<Second>>)
    [[nodiscard]] constexpr To
    dot(const First& a, const Second& b) noexcept(To::multiply_never_throws) {
  return record::detail::logged_dot<typename To::plain_type>(a, b);
}

}  // namespace fixproof
