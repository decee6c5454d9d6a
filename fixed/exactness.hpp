/// @file
/// The exact value of an operation, compared with a number: whether a result is exact, and if not,
/// on which side of it the exact value lies.
///
/// The operands and the number may have any formats and policies. No comparison rounds, overflows
/// or throws. The sign is opposite to that of the ternary value of MPFR, which compares the result
/// with the exact value.
///
///     constexpr q16_16 third = q16_16(1) / q16_16(3);
///     static_assert(compare_quotient(q16_16(1), q16_16(3), third) > 0);  // 1/3 is above it
///     static_assert(compare_product(q16_16(1.5), q16_16(0.25), q16_16(0.375)) == 0);
#pragma once

#include <compare>

#include "fixed/detail/storage.hpp"
#include "fixed/mixed.hpp"
#include "fixed/number.hpp"

namespace fixproof {

namespace detail {

/// a 2^-FA against b 2^-FB, for integers of at most BitsA and BitsB bits with the sign.
template <int BitsA, int FA, int BitsB, int FB, class IntA, class IntB>
constexpr std::strong_ordering order_of(const IntA& a, const IntB& b) noexcept {
  constexpr int up_a = larger(FB - FA, 0);
  constexpr int up_b = larger(FA - FB, 0);
  using wide = signed_t<larger(BitsA + up_a, BitsB + up_b)>;
  const wide x = static_cast<wide>(a) << up_a;
  const wide y = static_cast<wide>(b) << up_b;
  return ordering(x < y, y < x);
}

/// The product of two integers, exact.
template <class RawA, class RawB>
constexpr auto product_of(RawA a, RawB b) noexcept {
  using wide = signed_t<signed_bits<RawA> + signed_bits<RawB>>;
  return wide{a} * wide{b};
}

constexpr std::strong_ordering reversed_if(bool is_reversed, std::strong_ordering order) noexcept {
  return is_reversed ? 0 <=> order : order;
}

}  // namespace detail

/// The value of x against r, as after a conversion.
///
///     static_assert(compare_value(q16_16(1.00390625), q8_8(q16_16(1.00390625))) == 0);
template <class RawA, int FA, policy PA, class RawR, int FR, policy PR>
[[nodiscard]] constexpr std::strong_ordering compare_value(number<RawA, FA, PA> x,
                                                           number<RawR, FR, PR> r) noexcept {
  return detail::order_of<detail::signed_bits<RawA>, FA, detail::signed_bits<RawR>, FR>(x.raw(),
                                                                                        r.raw());
}

/// a + b against r.
template <class RawA, int FA, policy PA, class RawB, int FB, policy PB, class RawR, int FR,
          policy PR>
[[nodiscard]] constexpr std::strong_ordering compare_sum(number<RawA, FA, PA> a,
                                                         number<RawB, FB, PB> b,
                                                         number<RawR, FR, PR> r) noexcept {
  constexpr int fraction = detail::larger(FA, FB);
  constexpr int bits = detail::sum_bits<RawA, FA, RawB, FB>;
  using wide = detail::signed_t<bits>;
  return detail::order_of<bits, fraction, detail::signed_bits<RawR>, FR>(
      (wide{a.raw()} << (fraction - FA)) + (wide{b.raw()} << (fraction - FB)), r.raw());
}

/// a - b against r.
template <class RawA, int FA, policy PA, class RawB, int FB, policy PB, class RawR, int FR,
          policy PR>
[[nodiscard]] constexpr std::strong_ordering compare_difference(number<RawA, FA, PA> a,
                                                                number<RawB, FB, PB> b,
                                                                number<RawR, FR, PR> r) noexcept {
  // a against b + r.
  return 0 <=> compare_sum(b, r, a);
}

/// a * b against r.
template <class RawA, int FA, policy PA, class RawB, int FB, policy PB, class RawR, int FR,
          policy PR>
[[nodiscard]] constexpr std::strong_ordering compare_product(number<RawA, FA, PA> a,
                                                             number<RawB, FB, PB> b,
                                                             number<RawR, FR, PR> r) noexcept {
  constexpr int bits = detail::signed_bits<RawA> + detail::signed_bits<RawB>;
  return detail::order_of<bits, FA + FB, detail::signed_bits<RawR>, FR>(
      detail::product_of(a.raw(), b.raw()), r.raw());
}

/// n / d against r; unordered for a zero divisor.
template <class RawN, int FN, policy PN, class RawD, int FD, policy PD, class RawR, int FR,
          policy PR>
[[nodiscard]] constexpr std::partial_ordering compare_quotient(number<RawN, FN, PN> n,
                                                               number<RawD, FD, PD> d,
                                                               number<RawR, FR, PR> r) noexcept {
  if (d.raw() == 0) return std::partial_ordering::unordered;
  // n against r d, in the order that a negative divisor reverses.
  constexpr int bits = detail::signed_bits<RawR> + detail::signed_bits<RawD>;
  return detail::reversed_if(d.raw() < 0,
                             detail::order_of<detail::signed_bits<RawN>, FN, bits, FR + FD>(
                                 n.raw(), detail::product_of(r.raw(), d.raw())));
}

/// The square root of x against r; unordered for a negative x.
template <class RawA, int FA, policy PA, class RawR, int FR, policy PR>
[[nodiscard]] constexpr std::partial_ordering compare_sqrt(number<RawA, FA, PA> x,
                                                           number<RawR, FR, PR> r) noexcept {
  if (x.raw() < 0) return std::partial_ordering::unordered;
  if (r.raw() < 0) return std::partial_ordering::greater;
  return detail::order_of<detail::signed_bits<RawA>, FA, 2 * detail::signed_bits<RawR>, 2 * FR>(
      x.raw(), detail::product_of(r.raw(), r.raw()));
}

}  // namespace fixproof
