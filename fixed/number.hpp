/// \file
/// The fixed-point type.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "fixed/detail/divide.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixed {

/// A two's complement number with FractionBits bits before and after the binary point.
///
/// 16.16 covers -32768 to 32767 + 65535/65536 in steps of 2^-16 and takes four bytes; 8.8 covers
/// -128 to 127 + 255/256 in steps of 2^-8 and takes two. What inexact and out-of-range results
/// become is the policy's; no operation is undefined for any operand. Nothing throws unless the
/// policy says so: overflow::trap throws overflow_error, and a divide that its policy calls an
/// error throws divide_error.
///
///     static_assert(q16_16(1.5).raw() == 0x18000 && q16_16::from_raw(-1) < q16_16());
///     static_assert(q16_16(7) / q16_16(-2) == q16_16(-3.5));
///     static_assert(q16_16(32767) + q16_16(1) == q16_16(-32768));
///     static_assert(q16_16_saturating(300) * q16_16_saturating(300) ==
///                   std::numeric_limits<q16_16_saturating>::max());
///
/// \tparam FractionBits 16 or 8
/// \tparam P            the rules of rounding, overflow and division
template <int FractionBits, policy P = policies::wrapping>
class number {
 public:
  /// The stored integer: std::int32_t for 16.16, std::int16_t for 8.8.
  using raw_type = detail::raw_t<FractionBits>;

  /// Binary digits after the point, and before it with the sign.
  static constexpr int fraction_bits = FractionBits;
  /// The policy.
  static constexpr policy rules = P;
  /// Whether every operation but division returns.
  static constexpr bool never_throws = P.range != overflow::trap;
  /// Whether division returns for every divisor.
  static constexpr bool divide_never_throws = never_throws && P.fault == divide_fault::none;

  /// Zero.
  constexpr number() noexcept = default;

  /// The number whose stored integer is `raw`: raw / 2^FractionBits.
  static constexpr number from_raw(raw_type raw) noexcept {
    number result;
    result.raw_ = raw;
    return result;
  }

  /// The stored integer: the value times 2^FractionBits.
  [[nodiscard]] constexpr raw_type raw() const noexcept { return raw_; }

  /// An integer, exact; out of range by the policy.
  ///
  ///     static_assert(q16_16(40000) == q16_16(40000 - 65536));
  ///     static_assert(q16_16_saturating(40000).raw() == 0x7fffffff);
  template <std::integral Int>
  explicit constexpr number(Int value) noexcept(never_throws) {
    if constexpr (P.range == overflow::wrap) {
      raw_ = static_cast<raw_type>(static_cast<std::uint32_t>(value) << FractionBits);
    } else {
      const std::int64_t units = detail::clamp_far(value) * (std::int64_t{1} << FractionBits);
      raw_ = detail::narrow<P.range, raw_type>(
          units, [value] { detail::raise<overflow_error>("overflow", "conversion", value); });
    }
  }

  /// A float or double, rounded as products are and out of range by the policy; wrapping keeps the
  /// rounded value modulo the range, however large. NaN becomes 0 and an infinity the end of the
  /// range on its side; under overflow::trap NaN throws domain_error and infinities overflow_error.
  /// Decoded with integers: the same bits whatever the compiler's floating-point flags.
  ///
  ///     static_assert(q16_16(0.1).raw() == 6554);  // 0.1 is 6553.6 units
  ///     static_assert(q16_16_i386_unrounded(0.1).raw() == 6553);
  ///     static_assert(q16_16(std::numeric_limits<double>::quiet_NaN()) == q16_16());
  template <detail::binary_float Float>
  explicit constexpr number(Float value) noexcept(never_throws) {
    using kind = detail::scaled_float::kind;
    const detail::scaled_float x = detail::scale<P.multiply>(value, FractionBits);
    if (x.what == kind::finite || (x.what == kind::beyond && P.range == overflow::wrap)) {
      raw_ = detail::narrow<P.range, raw_type>(
          x.integer, [value] { detail::raise<overflow_error>("overflow", "conversion", value); });
      return;
    }
    if constexpr (P.range == overflow::trap) {
      if (x.what == kind::nan) detail::raise<domain_error>("domain error", "conversion", value);
      detail::raise<overflow_error>("overflow", "conversion", value);
    } else {
      if (x.what != kind::nan) raw_ = x.negative ? lowest : highest;
    }
  }

  /// A number of another width or policy: fraction bits that have no place are rounded as products
  /// are, out of range by the policy of the result.
  ///
  ///     static_assert(q8_8(q16_16(1.5)) == q8_8(1.5));
  ///     static_assert(q8_8(q16_16::from_raw(128)) == q8_8::from_raw(1));  // a half goes up
  template <int OtherBits, policy Q>
  requires(OtherBits != FractionBits ||
           Q != P) explicit constexpr number(number<OtherBits, Q> other) noexcept(never_throws) {
    if constexpr (OtherBits <= FractionBits) {
      raw_ = static_cast<raw_type>(other.raw() * (1 << (FractionBits - OtherBits)));
    } else {
      constexpr int dropped = OtherBits - FractionBits;
      const auto value = detail::shift_right<P.multiply>(std::int64_t{other.raw()}, dropped);
      raw_ = detail::narrow<P.range, raw_type>(
          value, [other] { detail::raise_overflow<OtherBits>("conversion", other.raw()); });
    }
  }

  /// The value, exact.
  explicit constexpr operator double() const noexcept {
    return static_cast<double>(raw_) / static_cast<double>(std::int32_t{1} << FractionBits);
  }

  /// The nearest float, halves to even, whatever the rounding mode of the processor.
  explicit constexpr operator float() const noexcept {
    return detail::to_float(raw_, FractionBits);
  }

  /// The whole part, toward zero as from double; where Int is too small for it, modulo 2^bits.
  /// See to_integer() for other roundings.
  ///
  ///     static_assert(static_cast<int>(q16_16(-1.5)) == -1);
  template <std::integral Int>
  requires(!std::same_as<Int, bool>) explicit constexpr operator Int() const noexcept {
    return static_cast<Int>(
        detail::shift_right<rounding::truncate>(std::int64_t{raw_}, FractionBits));
  }

  /// Whether the values are equal. Numbers of different types do not compare.
  friend constexpr bool operator==(number, number) noexcept = default;
  /// The order of the values.
  friend constexpr auto operator<=>(number, number) noexcept = default;

  /// The number itself.
  constexpr number operator+() const noexcept { return *this; }

  /// The negative, exact; that of the lowest number is out of range, by the policy.
  constexpr number operator-() const noexcept(never_throws) {
    return narrowed(-wide{raw_}, "operator-", *this);
  }

  /// The sum, exact; out of range by the policy.
  friend constexpr number operator+(number a, number b) noexcept(never_throws) {
    return narrowed(wide{a.raw_} + wide{b.raw_}, "operator+", a, b);
  }

  /// The difference, exact; out of range by the policy.
  friend constexpr number operator-(number a, number b) noexcept(never_throws) {
    return narrowed(wide{a.raw_} - wide{b.raw_}, "operator-", a, b);
  }

  /// The product, rounded once by policy::multiply; out of range by the policy.
  ///
  ///     constexpr auto unit = q16_16::from_raw(1);
  ///     static_assert(unit * q16_16(0.5) == unit && -unit * q16_16(0.5) == q16_16());
  friend constexpr number operator*(number a, number b) noexcept(never_throws) {
    const wide product = wide{a.raw_} * wide{b.raw_};
    return narrowed(detail::shift_right<P.multiply>(product, FractionBits), "operator*", a, b);
  }

  /// The quotient, rounded once by policy::divide; out of range by the policy. Division by zero,
  /// where the policy does not throw, gives the end of the range on the numerator's side, and 0 / 0
  /// is 0. Where it throws, divide_error is what a processor calls #DE; see policy::fault.
  ///
  ///     static_assert((q16_16(-2) / q16_16(3)).raw() == -43691);  // -43690.67
  ///     static_assert(q16_16(-1) / q16_16() == std::numeric_limits<q16_16>::lowest());
  friend constexpr number operator/(number n, number d) noexcept(divide_never_throws) {
    if constexpr (!divide_never_throws) {
      const detail::division end = detail::try_division<FractionBits, P>(n.raw_, d.raw_);
      if (end == detail::division::divide_error) {
        detail::raise<divide_error>("divide error", "operator/", operand{n.raw_}, operand{d.raw_});
      }
      if (end == detail::division::out_of_range) {
        detail::raise_overflow<FractionBits>("operator/", n.raw_, d.raw_);
      }
    }
    return from_raw(detail::total_divide<FractionBits, P>(n.raw_, d.raw_));
  }

  /// As operator+; the number stays as it was if that throws.
  constexpr number& operator+=(number b) noexcept(never_throws) { return *this = *this + b; }
  /// As operator-; the number stays as it was if that throws.
  constexpr number& operator-=(number b) noexcept(never_throws) { return *this = *this - b; }
  /// As operator*; the number stays as it was if that throws.
  constexpr number& operator*=(number b) noexcept(never_throws) { return *this = *this * b; }
  /// As operator/; the number stays as it was if that throws.
  constexpr number& operator/=(number b) noexcept(divide_never_throws) { return *this = *this / b; }

 private:
  using wide = detail::wide_t<FractionBits>;
  using operand = detail::operand<FractionBits>;

  static constexpr raw_type lowest = std::numeric_limits<raw_type>::min();
  static constexpr raw_type highest = std::numeric_limits<raw_type>::max();

  template <class... Operands>
  static constexpr number narrowed(wide value, const char* operation,
                                   Operands... operands) noexcept(never_throws) {
    return from_raw(detail::narrow<P.range, raw_type>(
        value, [&] { detail::raise_overflow<FractionBits>(operation, operands.raw_...); }));
  }

  raw_type raw_ = 0;
};

/// n / d, or nothing where there is no quotient to return: where operator/ throws, and for a zero
/// divisor.
///
///     static_assert(try_divide(q16_16(1), q16_16(2)) == q16_16(0.5));
///     static_assert(!try_divide(q16_16(1), q16_16(0)));
///     static_assert(!try_divide(q16_16_i8088(1), q16_16_i8088(0.5)));  // the whole part is 0
template <int FractionBits, policy P>
constexpr std::optional<number<FractionBits, P>> try_divide(number<FractionBits, P> n,
                                                            number<FractionBits, P> d) noexcept {
  if (detail::try_division<FractionBits, P>(n.raw(), d.raw()) != detail::division::done) {
    return std::nullopt;
  }
  return number<FractionBits, P>::from_raw(detail::total_divide<FractionBits, P>(n.raw(), d.raw()));
}

/// 16.16: every operation to nearest, halves up; wraps.
using q16_16 = number<16>;
/// \name 16.16 by other rules: those that fixed::policies has by the same name
/// \{

/// 16.16 by the policy of that name.
using q16_16_saturating = number<16, policies::saturating>;
using q16_16_trapping = number<16, policies::trapping>;
using q16_16_i386 = number<16, policies::i386_rounded>;
using q16_16_i386_mul_rounded = number<16, policies::i386_mul_rounded>;
using q16_16_i386_div_rounded = number<16, policies::i386_div_rounded>;
using q16_16_i386_unrounded = number<16, policies::i386_unrounded>;
using q16_16_i8088 = number<16, policies::i8088_rounded>;
using q16_16_i8088_mul_rounded = number<16, policies::i8088_mul_rounded>;
using q16_16_i8088_div_rounded = number<16, policies::i8088_div_rounded>;
using q16_16_i8088_unrounded = number<16, policies::i8088_unrounded>;
/// \}

/// 8.8 by the rules of q16_16.
using q8_8 = number<8>;
/// \name 8.8 by other rules: those that fixed::policies has by the same name
/// \{

/// 8.8 by the policy of that name.
using q8_8_saturating = number<8, policies::saturating>;
using q8_8_trapping = number<8, policies::trapping>;
using q8_8_i386 = number<8, policies::i386_rounded>;
using q8_8_i386_mul_rounded = number<8, policies::i386_mul_rounded>;
using q8_8_i386_div_rounded = number<8, policies::i386_div_rounded>;
using q8_8_i386_unrounded = number<8, policies::i386_unrounded>;
using q8_8_i8088 = number<8, policies::i8088_rounded>;
using q8_8_i8088_mul_rounded = number<8, policies::i8088_mul_rounded>;
using q8_8_i8088_div_rounded = number<8, policies::i8088_div_rounded>;
using q8_8_i8088_unrounded = number<8, policies::i8088_unrounded>;
/// \}

}  // namespace fixed
