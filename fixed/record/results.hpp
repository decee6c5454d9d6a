/// @file
/// Recorded forms of the functions of fixed/results.hpp, whose result has a format of its own.
#pragma once

#include <type_traits>

#include "fixed/fixed.hpp"
#include "fixed/record/checked.hpp"
#include "fixed/record/note.hpp"
#include "fixed/record/number.hpp"

namespace fixproof {

/// @cond
// NOLINTBEGIN(cppcoreguidelines-macro-usage,bugprone-macro-parentheses): defines functions
#define FIXPROOF_RECORDED_TO(name, kind_name)                                                      \
  template <class To, class Number>                                                                \
  requires any_number<To>                                                                          \
  [[nodiscard]] constexpr To name(recorded_number<Number> x,                                       \
                                  record::place from = FIXPROOF_HERE) noexcept(To::never_throws) { \
    using result = typename record::detail::plain_type_of<To>::type;                               \
    return record::detail::logged<record::kind::kind_name, result>(                                \
        from, [](Number a) { return fixproof::name<result>(a); }, x.value_);                       \
  }
#define FIXPROOF_RECORDED_SIN_COS_TO(name)                                                        \
  template <class To, class Number>                                                               \
  requires any_number<To>                                                                         \
  [[nodiscard]] constexpr sin_and_cos<To> name(                                                   \
      recorded_number<Number> x, record::place from = FIXPROOF_HERE) noexcept(To::never_throws) { \
    using result = typename record::detail::plain_type_of<To>::type;                              \
    const sin_and_cos<result> both = record::detail::logged<record::kind::name, result>(          \
        from, [](Number a) { return fixproof::name<result>(a); }, x.value_);                      \
    return {both.sin, both.cos};                                                                  \
  }
// NOLINTEND(cppcoreguidelines-macro-usage,bugprone-macro-parentheses)

FIXPROOF_RECORDED_TO(sqrt, sqrt)
FIXPROOF_RECORDED_TO(sin, sin)
FIXPROOF_RECORDED_TO(cos, cos)
FIXPROOF_RECORDED_TO(tan, tan)
FIXPROOF_RECORDED_TO(sin_of_degrees, sin_of_degrees)
FIXPROOF_RECORDED_TO(cos_of_degrees, cos_of_degrees)
FIXPROOF_RECORDED_TO(tan_of_degrees, tan_of_degrees)
FIXPROOF_RECORDED_TO(sin_of_turns, sin_of_turns)
FIXPROOF_RECORDED_TO(cos_of_turns, cos_of_turns)
FIXPROOF_RECORDED_TO(tan_of_turns, tan_of_turns)
FIXPROOF_RECORDED_SIN_COS_TO(sin_cos)
FIXPROOF_RECORDED_SIN_COS_TO(sin_cos_of_degrees)
FIXPROOF_RECORDED_SIN_COS_TO(sin_cos_of_turns)
FIXPROOF_RECORDED_TO(exp, exp)
FIXPROOF_RECORDED_TO(exp2, exp2)
FIXPROOF_RECORDED_TO(expm1, expm1)
FIXPROOF_RECORDED_TO(sinh, sinh)
FIXPROOF_RECORDED_TO(cosh, cosh)
FIXPROOF_RECORDED_TO(tanh, tanh)
FIXPROOF_RECORDED_TO(log, log)
FIXPROOF_RECORDED_TO(log1p, log1p)
FIXPROOF_RECORDED_TO(log2, log2)
FIXPROOF_RECORDED_TO(log10, log10)
FIXPROOF_RECORDED_TO(atan, atan)
FIXPROOF_RECORDED_TO(asin, asin)
FIXPROOF_RECORDED_TO(acos, acos)
#undef FIXPROOF_RECORDED_TO
#undef FIXPROOF_RECORDED_SIN_COS_TO
/// @endcond

/// As atan2<To>() of plain numbers.
template <class To, class Number>
requires any_number<To>
[[nodiscard]] constexpr To atan2(recorded_number<Number> y,
                                 std::type_identity_t<recorded_number<Number>> x,
                                 record::place from = FIXPROOF_HERE) noexcept(To::never_throws) {
  using result = typename record::detail::plain_type_of<To>::type;
  return record::detail::logged<record::kind::atan2, result>(
      from, [](Number a, Number b) { return fixproof::atan2<result>(a, b); }, y.value_, x.value_);
}
/// As hypot<To>() of plain numbers.
template <class To, any_number First, any_number Second, any_number Third>
requires(record::detail::is_recorded<First> || record::detail::is_recorded<Second> ||
         record::detail::is_recorded<Third>) [[nodiscard]] constexpr To
    hypot(First x, Second y, Third z,
          record::place from = FIXPROOF_HERE) noexcept(To::never_throws) {
  using Number = typename record::detail::plain_type_of<To>::type;
  return record::detail::logged<record::kind::hypot, Number>(
      from, [](auto a, auto b, auto c) { return fixproof::hypot<Number>(a, b, c); },
      record::detail::plain(x), record::detail::plain(y), record::detail::plain(z));
}

}  // namespace fixproof
