/// @file
/// Durations that count in numbers, beside integers and durations of integers, as those of double:
/// `d * 3`, `d + 1s`, `d < 1s`. The standard library requires implicit conversions for these.
/// Durations of one number type need no header.
///
///     using namespace std::chrono_literals;
///     constexpr std::chrono::duration<q16_16> d(q16_16(1.5));
///     static_assert(d * 3 == 4500ms && d + 1s < 2501ms && 1s - d == -500ms);
#pragma once

#include <chrono>
#include <compare>
#include <ratio>
#include <type_traits>

#include "fixed/detail/integer.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/number.hpp"
#include "fixed/traits.hpp"

namespace fixproof {

namespace detail {

/// A duration in the ticks of To, which divide its own. The policy handles overflow as if the
/// product alone were out of range, because a factor is at least 1.
template <class To, class Rep, class Period>
constexpr To in_ticks_of(std::chrono::duration<Rep, Period> x) {
  constexpr auto factor = std::ratio_divide<Period, typename To::period>::num;
  return To(static_cast<typename To::rep>(x.count()) * factor);
}

/// The order of a duration of numbers and one of integers, exact.
template <class Numbers, class Integers>
constexpr std::strong_ordering order_of(Numbers x, Integers y) noexcept {
  using ticks = typename std::common_type_t<Numbers, Integers>::period;
  using wide = wide_integer<4>;
  const wide left =
      wide{x.count().raw()} * wide{std::ratio_divide<typename Numbers::period, ticks>::num};
  const wide right =
      wide{y.count()} * wide{std::ratio_divide<typename Integers::period, ticks>::num}
      << Numbers::rep::fraction_bits;
  return ordering(left < right, right < left);
}

}  // namespace detail

/// @name Durations and integers
/// \{

/// As those of the count.
template <class Raw, int Point, policy Rules, class Period, detail::value_integer<Rules> Int>
[[nodiscard]] constexpr auto operator*(std::chrono::duration<number<Raw, Point, Rules>, Period> x,
                                       Int n) {
  return decltype(x)(x.count() * n);
}
template <class Int, class Raw, int Point, policy Rules, class Period>
requires detail::value_integer<Int, Rules>
[[nodiscard]] constexpr auto operator*(Int n,
                                       std::chrono::duration<number<Raw, Point, Rules>, Period> x) {
  return decltype(x)(x.count() * n);
}
template <class Raw, int Point, policy Rules, class Period, detail::value_integer<Rules> Int>
[[nodiscard]] constexpr auto operator/(std::chrono::duration<number<Raw, Point, Rules>, Period> x,
                                       Int n) {
  return decltype(x)(x.count() / n);
}
template <class Raw, int Point, policy Rules, class Period, detail::value_integer<Rules> Int>
[[nodiscard]] constexpr auto operator%(std::chrono::duration<number<Raw, Point, Rules>, Period> x,
                                       Int n) {
  return decltype(x)(x.count() % n);
}
template <class Raw, int Point, policy Rules, class Period, detail::value_integer<Rules> Int>
constexpr auto& operator*=(std::chrono::duration<number<Raw, Point, Rules>, Period>& x, Int n) {
  return x = x * n;
}
template <class Raw, int Point, policy Rules, class Period, detail::value_integer<Rules> Int>
constexpr auto& operator/=(std::chrono::duration<number<Raw, Point, Rules>, Period>& x, Int n) {
  return x = x / n;
}
/// \}

/// @name Durations of numbers and durations of integers
/// \{

/// The sum and the difference, in the ticks that both are multiples of. The policy handles
/// overflow.
template <class Raw, int Point, policy Rules, class Period, class Int, class OtherPeriod>
requires detail::value_integer<Int, Rules>
[[nodiscard]] constexpr auto operator+(std::chrono::duration<number<Raw, Point, Rules>, Period> x,
                                       std::chrono::duration<Int, OtherPeriod> y) {
  using common = std::common_type_t<decltype(x), decltype(y)>;
  return common(detail::in_ticks_of<common>(x).count() + detail::in_ticks_of<common>(y).count());
}
template <class Int, class OtherPeriod, class Raw, int Point, policy Rules, class Period>
requires detail::value_integer<Int, Rules>
[[nodiscard]] constexpr auto operator+(std::chrono::duration<Int, OtherPeriod> y,
                                       std::chrono::duration<number<Raw, Point, Rules>, Period> x) {
  return x + y;
}
template <class Raw, int Point, policy Rules, class Period, class Int, class OtherPeriod>
requires detail::value_integer<Int, Rules>
[[nodiscard]] constexpr auto operator-(std::chrono::duration<number<Raw, Point, Rules>, Period> x,
                                       std::chrono::duration<Int, OtherPeriod> y) {
  using common = std::common_type_t<decltype(x), decltype(y)>;
  return common(detail::in_ticks_of<common>(x).count() - detail::in_ticks_of<common>(y).count());
}
template <class Int, class OtherPeriod, class Raw, int Point, policy Rules, class Period>
requires detail::value_integer<Int, Rules>
[[nodiscard]] constexpr auto operator-(std::chrono::duration<Int, OtherPeriod> y,
                                       std::chrono::duration<number<Raw, Point, Rules>, Period> x) {
  using common = std::common_type_t<decltype(x), decltype(y)>;
  return common(detail::in_ticks_of<common>(y).count() - detail::in_ticks_of<common>(x).count());
}

/// As x = x + y and x = x - y, if the ticks of x divide those of y.
template <class Raw, int Point, policy Rules, class Period, class Int, class OtherPeriod>
requires(detail::value_integer<Int, Rules>&& std::ratio_divide<OtherPeriod, Period>::den ==
         1) constexpr auto&
operator+=(std::chrono::duration<number<Raw, Point, Rules>, Period>& x,
           std::chrono::duration<Int, OtherPeriod> y) {
  return x = x + y;
}
template <class Raw, int Point, policy Rules, class Period, class Int, class OtherPeriod>
requires(detail::value_integer<Int, Rules>&& std::ratio_divide<OtherPeriod, Period>::den ==
         1) constexpr auto&
operator-=(std::chrono::duration<number<Raw, Point, Rules>, Period>& x,
           std::chrono::duration<Int, OtherPeriod> y) {
  return x = x - y;
}

/// Compares values, also with durations outside the range of the type.
template <class Raw, int Point, policy Rules, class Period, class Int, class OtherPeriod>
requires detail::value_integer<Int, Rules>
[[nodiscard]] constexpr bool operator==(std::chrono::duration<number<Raw, Point, Rules>, Period> x,
                                        std::chrono::duration<Int, OtherPeriod> y) noexcept {
  return detail::order_of(x, y) == 0;
}
template <class Int, class OtherPeriod, class Raw, int Point, policy Rules, class Period>
requires detail::value_integer<Int, Rules>
[[nodiscard]] constexpr bool operator==(
    std::chrono::duration<Int, OtherPeriod> y,
    std::chrono::duration<number<Raw, Point, Rules>, Period> x) noexcept {
  return detail::order_of(x, y) == 0;
}
/// @cond
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares operators; those of the standard library
// would be as good as a rewritten <=>.
#define FIXED_DURATION_ORDER(op)                                                            \
  template <class Raw, int Point, policy Rules, class Period, class Int, class OtherPeriod> \
  requires detail::value_integer<Int, Rules>                                                \
  [[nodiscard]] constexpr bool operator op(                                                 \
      std::chrono::duration<number<Raw, Point, Rules>, Period> x,                           \
      std::chrono::duration<Int, OtherPeriod> y) noexcept {                                 \
    return detail::order_of(x, y) op 0;                                                     \
  }                                                                                         \
  template <class Int, class OtherPeriod, class Raw, int Point, policy Rules, class Period> \
  requires detail::value_integer<Int, Rules>                                                \
  [[nodiscard]] constexpr bool operator op(                                                 \
      std::chrono::duration<Int, OtherPeriod> y,                                            \
      std::chrono::duration<number<Raw, Point, Rules>, Period> x) noexcept {                \
    return 0 op detail::order_of(x, y);                                                     \
  }
FIXED_DURATION_ORDER(<)
FIXED_DURATION_ORDER(<=)
FIXED_DURATION_ORDER(>)
FIXED_DURATION_ORDER(>=)
#undef FIXED_DURATION_ORDER
/// @endcond
/// \}

}  // namespace fixproof
