/// @file
/// Exact intermediate results: a * b / c, the ratio of two integers, and sums of products.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/divide.hpp"
#include "fixed/detail/operands.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/result.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/trap.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"

namespace fixproof {

namespace detail {

/// Holds the product of two Raws and its quotient by a third, in at most 64 bits for a Raw of at
/// most 32 bits.
template <class Raw>
using numerator_t = std::conditional_t<
    std::is_unsigned_v<Raw> && bits_of<Raw> == 32, std::uint64_t,
    std::conditional_t<(bits_of<Raw> <= 32), product_t<Raw>, signed_t<2 * signed_bits<Raw> + 1>>>;

/// A sum of 32 or 64 bits that remembers whether it always fitted. @pre |term| < start
template <class Int>
class watched_sum {
 public:
  constexpr void add(Int term) noexcept { set(static_cast<bits>(sum_) + static_cast<bits>(term)); }
  constexpr void subtract(Int term) noexcept {
    set(static_cast<bits>(sum_) - static_cast<bits>(term));
  }

  /// The sum. Executes a trap instruction if it or an earlier one did not fit.
  [[nodiscard]] constexpr Int value() const noexcept {
    if (all_ >> 31 != 0) trap();
    return sum_ - start;
  }

 private:
  using bits = std::make_unsigned_t<Int>;
  // A sum that fits is not negative with this. The first one that does not fit is negative.
  static constexpr Int start = Int{1} << (bits_of<Int> - 2);

  // Keeps the upper bits of all sums, which takes an instruction where a branch takes two.
  constexpr void set(bits sum) noexcept {
    sum_ = static_cast<Int>(sum);
    all_ |= static_cast<std::uint32_t>(sum >> (bits_of<Int> - 32));
  }

  Int sum_ = start;
  std::uint32_t all_ = 0;
};

/// A sum that has room for every term.
template <class Wide>
class roomy_sum {
 public:
  template <class Term>
  constexpr void add(const Term& term) noexcept {
    sum_ += term;
  }
  template <class Term>
  constexpr void subtract(const Term& term) noexcept {
    sum_ -= term;
  }
  [[nodiscard]] constexpr const Wide& value() const noexcept { return sum_; }

 private:
  Wide sum_{0};
};

}  // namespace detail

/// a * b / c, rounded once by policy::divide. The policy handles overflow of the result, as for
/// quotients; the product cannot overflow. A zero divisor is handled as in operator/, with the sign
/// of the product. Other limits of a processor's divide do not apply: mul_div() uses the whole
/// divisor, and only a zero divisor is a divide error.
///
///     static_assert(mul_div(q16_16(30000), q16_16(20000), q16_16(25000)) == q16_16(24000));
template <class Raw, int Point, policy Rules>
[[nodiscard]] constexpr number<Raw, Point, Rules> mul_div(
    number<Raw, Point, Rules> a, number<Raw, Point, Rules> b,
    number<Raw, Point, Rules> c) noexcept(number<Raw, Point, Rules>::divide_never_throws) {
  using Number = number<Raw, Point, Rules>;
  using wide = detail::numerator_t<Raw>;
  const wide product = wide{a.raw()} * wide{b.raw()};
  if (c.raw() == 0) {
    if constexpr (!Number::divide_never_throws) {
      using operand = detail::operand<Raw, Point>;
      detail::raise<divide_error>("divide error", "mul_div", operand{a.raw()}, operand{b.raw()},
                                  operand{c.raw()});
    }
    return Number::from_raw(detail::by_zero<Raw>(product < wide{0}, product == wide{0}));
  }
  return Number::from_raw(detail::narrow<Rules.quotient_range(), Raw>(
      detail::quick_ratio<Rules.divide>(product, wide{c.raw()}),
      [&] { detail::raise_overflow<Point>("mul_div", a.raw(), b.raw(), c.raw()); }));
}

/// The quotient of two integers as a number, rounded once by policy::divide. The policy handles
/// overflow and a zero divisor, as for quotients; see mul_div().
///
///     static_assert(ratio<q2_30>(1, 3).raw() == 357913941);  // 2^30 / 3
///     static_assert(ratio<q16_16>(1000000007, 1000000000).raw() == 65536);
template <class Number, detail::integer Int>
[[nodiscard]] constexpr Number ratio(Int n, Int d) noexcept(Number::divide_never_throws) {
  using raw = typename Number::raw_type;
  constexpr int Point = Number::fraction_bits;
  using wide = detail::signed_t<detail::larger(detail::signed_bits<Int> + Point + 1,
                                               detail::signed_bits<raw>)>;
  if (d == 0) {
    if constexpr (!Number::divide_never_throws) {
      detail::raise<divide_error>("divide error", "ratio", n, d);
    }
    return Number::from_raw(detail::by_zero<raw>(n < 0, n == 0));
  }
  return Number::from_raw(detail::narrow<Number::rules.quotient_range(), raw>(
      detail::rounded_ratio<Number::rules.divide>(wide{n} << Point, wide{d}),
      [&] { detail::raise<overflow_error>("overflow", "ratio", n, d); }));
}

/// A sum of numbers and products that is exact until result() rounds it once.
///
/// It has room for 2^62 terms of any value, or for Terms. A program that promises few terms gets a
/// sum of 32 or 64 bits, if that holds them all. Beyond Terms, the sum is still exact as long as it
/// fits. After one that does not fit, result() executes a trap instruction, under every policy, and
/// does not compile in a constant expression. A sum of over 64 bits has room for 2^62 and is not
/// checked.
///
///     static_assert([] {
///       accumulator<q2_30> sum;  // a biquad filter with coefficients beyond 1
///       sum.add_product(q2_30(1.75), q2_30(1.5)).subtract_product(q2_30(1.25), q2_30(1.5));
///       return sum.result() == q2_30(0.75);
///     }());
///     static_assert(sizeof(accumulator<q1_15, 8>) == 16 && sizeof(accumulator<q8_0, 8>) == 8);
template <class Number, std::uint64_t Terms = std::uint64_t{1} << 62>
class accumulator {
  static_assert(Terms > 0 && Terms <= std::uint64_t{1} << 62, "an accumulator has 1 to 2^62 terms");
  using raw = typename Number::raw_type;
  static constexpr int fraction = Number::fraction_bits;
  // No term is above 2^term_bits, the square of the lowest number or that number as a term.
  static constexpr int term_bits =
      detail::signed_bits<raw> - 1 + detail::larger(detail::signed_bits<raw> - 1, fraction);
  // Terms of them are below 2^few_bits. Two bits more leave room for the sign, and for a term or
  // for rounding. A sum of more than 64 bits has room for 2^62 terms.
  static constexpr int few_bits = term_bits + std::bit_width(Terms);
  static constexpr bool is_checked = few_bits <= 62;
  using wide = detail::signed_t<is_checked ? few_bits + 2 : term_bits + 64>;
  using product = detail::term_t<raw, raw, wide>;
  static constexpr int sum_bits = is_checked ? detail::bits_of<wide> - 1 : term_bits + 64;

 public:
  /// Zero.
  constexpr accumulator() noexcept = default;

  /// Adds a number.
  constexpr accumulator& add(Number x) noexcept {
    sum_.add(wide{x.raw()} << fraction);
    return *this;
  }
  /// Subtracts a number.
  constexpr accumulator& subtract(Number x) noexcept {
    sum_.subtract(wide{x.raw()} << fraction);
    return *this;
  }
  /// Adds a * b without rounding it.
  constexpr accumulator& add_product(Number a, Number b) noexcept {
    sum_.add(product{a.raw()} * product{b.raw()});
    return *this;
  }
  /// Subtracts a * b without rounding it.
  constexpr accumulator& subtract_product(Number a, Number b) noexcept {
    sum_.subtract(product{a.raw()} * product{b.raw()});
    return *this;
  }

  /// The sum, rounded once by policy::multiply. The policy handles overflow, as for products.
  [[nodiscard]] constexpr Number result() const noexcept(Number::multiply_never_throws) {
    const auto fail = [] { detail::raise<overflow_error>("overflow", "accumulator::result"); };
    // The shifts of a wide_integer take hundreds of instructions.
    if constexpr (std::is_same_v<wide, detail::wide_integer<2>> &&
                  detail::has_wide_sum<raw, fraction>) {
      return detail::rounded_sum<Number>(
          detail::wide_sum(sum_.value().word(0), sum_.value().word(1)), fail);
    } else {
      return Number::from_raw(detail::narrow<Number::rules.product_range(), raw>(
          detail::shift_right<Number::rules.multiply>(sum_.value(), fraction), fail));
    }
  }

  /// The sum as a To, rounded once by policy::multiply of To. The policy of To handles overflow, as
  /// for products.
  ///
  ///     static_assert(accumulator<q1_31>().add(q1_31(-1)).subtract(q1_31(0.5)).result<q2_30>() ==
  ///                   q2_30(-1.5));
  template <class To>
  requires detail::is_plain_number<To>
  [[nodiscard]] constexpr To result() const noexcept(To::multiply_never_throws) {
    return To::from_raw(detail::narrow<To::rules.product_range(), typename To::raw_type>(
        detail::rescaled<To, 2 * fraction, sum_bits>(sum_.value()),
        [] { detail::raise<overflow_error>("overflow", "accumulator::result"); }));
  }

 private:
  std::conditional_t<is_checked, detail::watched_sum<wide>, detail::roomy_sum<wide>> sum_{};
};

/// @cond
FIXED_REFUSED_MIX(mul_div)
/// @endcond

}  // namespace fixproof
