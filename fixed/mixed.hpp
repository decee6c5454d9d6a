/// @file
/// Arithmetic on numbers of different formats. The caller names the type of the result; the exact
/// result is rounded once to that type.
#pragma once

#include <limits>

#include "fixed/detail/divide.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/result.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/number.hpp"

namespace fixproof {

namespace detail {

/// The bits of a sum of numbers of two formats, with the sign.
template <class RawA, int FA, class RawB, int FB>
inline constexpr int sum_bits = larger(signed_bits<RawA> + larger(FA, FB) - FA,
                                       signed_bits<RawB> + larger(FA, FB) - FB) +
                                1;

}  // namespace detail

/// a + b as a To, rounded once by policy::multiply of To. Its policy handles overflow.
///
///     static_assert(add<q16_16>(q8_8(1.5), q2_30(0.25)) == q16_16(1.75));
template <class To, class RawA, int FA, policy PA, class RawB, int FB, policy PB>
[[nodiscard]] constexpr To add(number<RawA, FA, PA> a,
                               number<RawB, FB, PB> b) noexcept(To::never_throws) {
  constexpr int fraction = detail::larger(FA, FB);
  constexpr int bits = detail::sum_bits<RawA, FA, RawB, FB>;
  using wide = detail::signed_t<bits>;
  const wide sum = (wide{a.raw()} << (fraction - FA)) + (wide{b.raw()} << (fraction - FB));
  return detail::narrowed_to<To, To::rules.range>(detail::rescaled<To, fraction, bits>(sum), "add",
                                                  a, b);
}

/// a - b as a To, rounded once by policy::multiply of To. Its policy handles overflow.
template <class To, class RawA, int FA, policy PA, class RawB, int FB, policy PB>
[[nodiscard]] constexpr To subtract(number<RawA, FA, PA> a,
                                    number<RawB, FB, PB> b) noexcept(To::never_throws) {
  constexpr int fraction = detail::larger(FA, FB);
  constexpr int bits = detail::sum_bits<RawA, FA, RawB, FB>;
  using wide = detail::signed_t<bits>;
  const wide difference = (wide{a.raw()} << (fraction - FA)) - (wide{b.raw()} << (fraction - FB));
  return detail::narrowed_to<To, To::rules.range>(detail::rescaled<To, fraction, bits>(difference),
                                                  "subtract", a, b);
}

/// a * b as a To, rounded once by policy::multiply of To. Its policy handles overflow.
///
///     static_assert(multiply<q16_16>(q16_16(100), q2_30(0.25)) == q16_16(25));
template <class To, class RawA, int FA, policy PA, class RawB, int FB, policy PB>
[[nodiscard]] constexpr To multiply(number<RawA, FA, PA> a,
                                    number<RawB, FB, PB> b) noexcept(To::multiply_never_throws) {
  constexpr int bits = detail::signed_bits<RawA> + detail::signed_bits<RawB>;
  using wide = detail::signed_t<bits>;
  return detail::narrowed_to<To, To::rules.product_range()>(
      detail::rescaled<To, FA + FB, bits>(wide{a.raw()} * wide{b.raw()}), "multiply", a, b);
}

/// n / d as a To, rounded once by policy::divide of To. Its policy handles overflow and a zero
/// divisor. A policy that describes the divide of one processor does not compile.
///
///     static_assert(divide<q2_30>(q16_16(1), q16_16(3)).raw() == 357913941);  // 2^30 / 3
template <class To, class RawA, int FA, policy PA, class RawB, int FB, policy PB>
[[nodiscard]] constexpr To divide(number<RawA, FA, PA> n,
                                  number<RawB, FB, PB> d) noexcept(To::divide_never_throws) {
  static_assert(
      To::rules.divisor == divisor_width::full &&
          (To::rules.fault == divide_fault::none || To::rules.fault == divide_fault::zero_divisor),
      "divide<To>() needs a policy with divisor_width::full and no divide_fault of a "
      "processor");
  using raw = typename To::raw_type;
  constexpr int up = To::fraction_bits + FB - FA;
  using wide = detail::signed_t<detail::largest(
      detail::signed_bits<raw>, detail::signed_bits<RawA> + detail::larger(up, 0) + 1,
      detail::signed_bits<RawB> + detail::larger(-up, 0) + 1)>;
  if (d.raw() == 0) {
    if constexpr (!To::divide_never_throws) {
      detail::raise<divide_error>("divide error", "divide", detail::operand<RawA, FA>{n.raw()},
                                  detail::operand<RawB, FB>{d.raw()});
    }
    return To::from_raw(detail::by_zero<raw>(n.raw() < 0, n.raw() == 0));
  }
  return detail::narrowed_to<To, To::rules.quotient_range()>(
      detail::rounded_ratio<To::rules.divide>(wide{n.raw()} << detail::larger(up, 0),
                                              wide{d.raw()} << detail::larger(-up, 0)),
      "divide", n, d);
}

}  // namespace fixproof
