/// @file
/// The fixed-point type.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "fixed/detail/arguments.hpp"
#include "fixed/detail/bit_cast.hpp"
#include "fixed/detail/convert.hpp"
#include "fixed/detail/divide.hpp"
#include "fixed/detail/exact.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/instead.hpp"
#include "fixed/detail/integer.hpp"
#include "fixed/detail/other_floats.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof {

/// A number stored as an integer of 8 to 64 bits: its value is the integer times 2^-FractionBits.
///
/// 16.16 covers -32768 to 32767 + 65535/65536 in steps of 2^-16 and takes four bytes; 8.8 covers
/// -128 to 127 + 255/256 in steps of 2^-8 and takes two. The policy decides how inexact results are
/// rounded and how out-of-range results are handled. Every result is the exact one, rounded once.
/// No operand causes undefined behaviour. Operations throw only if the policy says so:
/// overflow::trap throws overflow_error, and a divide that policy::fault treats as an error throws
/// divide_error.
///
///     static_assert(q16_16(1.5).raw() == 0x18000 && q16_16::from_raw(-1) < q16_16());
///     static_assert(q16_16(7) / q16_16(-2) == q16_16(-3.5));
///     static_assert(q16_16(32767) + q16_16(1) == q16_16(-32768));
///     static_assert(q16_16_saturating(300) * q16_16_saturating(300) ==
///                   std::numeric_limits<q16_16_saturating>::max());
///
/// @tparam Raw          the stored integer: signed or unsigned, of 8 to 64 bits
/// @tparam FractionBits the binary digits after the point: 0 to the width of Raw
/// @tparam Rules        the rules for rounding, overflow and division
template <class Raw, int FractionBits, policy Rules = policies::wrapping>
class number {
  static_assert(detail::are_number_arguments<Raw, FractionBits, Rules>());

 public:
  /// The stored integer.
  using raw_type = Raw;

  /// Binary digits after the point.
  static constexpr int fraction_bits = FractionBits;
  /// The policy.
  static constexpr policy rules = Rules;
  /// Whether no sum, difference or conversion throws.
  static constexpr bool never_throws = Rules.range != overflow::trap;
  /// Whether no product throws.
  static constexpr bool multiply_never_throws = Rules.product_range() != overflow::trap;
  /// Whether division never throws.
  static constexpr bool divide_never_throws =
      Rules.quotient_range() != overflow::trap && Rules.fault == divide_fault::none;

  /// Zero.
  FIXED_ALWAYS_INLINE constexpr number() noexcept = default;

  /// The number whose stored integer is `raw`: raw / 2^FractionBits.
  [[nodiscard]] FIXED_ALWAYS_INLINE static constexpr number from_raw(raw_type raw) noexcept {
    number result;
    result.raw_ = raw;
    return result;
  }
  /// @cond
  template <class Type>
  requires std::is_floating_point_v<Type>
  static number from_raw(Type)
      FIXED_INSTEAD("from_raw takes the stored integer: to convert a value, write q16_16(1.5)");
  template <class OtherRaw, int OtherBits, policy OtherRules>
  static number from_raw(number<OtherRaw, OtherBits, OtherRules>)
      FIXED_INSTEAD("from_raw takes the stored integer: write from_raw(x.raw())");
  /// @endcond

  /// The stored integer: the value times 2^FractionBits.
  [[nodiscard]] constexpr raw_type raw() const noexcept { return raw_; }

  /// Converts an integer exactly. The policy handles overflow.
  ///
  ///     static_assert(q16_16(40000) == q16_16(40000 - 65536));
  ///     static_assert(q16_16_saturating(40000).raw() == 0x7fffffff);
  template <detail::value_integer<Rules> Int>
  explicit constexpr number(Int value) noexcept(never_throws)
      : raw_(detail::narrow<Rules.range, raw_type>(
            detail::units<raw_type, FractionBits, Rules.range>(value),
            [value] { detail::raise<overflow_error>("overflow", "conversion", value); })) {}

  /// Converts a float or double, rounded by policy::multiply. The policy handles overflow; wrapping
  /// keeps the rounded value modulo the range, however large. NaN becomes 0 and an infinity becomes
  /// the end of the range on its side; under overflow::trap, NaN throws domain_error and an
  /// infinity throws overflow_error. Floating-point flags and the processor's rounding mode do not
  /// change the result.
  ///
  ///     static_assert(q16_16(0.1).raw() == 6554);  // 0.1 is 6553.6 units
  ///     static_assert(q16_16_i386_unrounded(0.1).raw() == 6553);
  ///     static_assert(q16_16(std::numeric_limits<double>::quiet_NaN()) == q16_16());
  template <detail::binary_float Float>
  requires(!Rules.moving) explicit constexpr number(Float value) noexcept(never_throws) {
    if constexpr (detail::has_fast_conversion<Raw, Rules.range>) {
      raw_ = detail::converted<Rules.multiply, Rules.range, Raw, FractionBits>(value);
    } else {
      raw_ = converted_in_integers(value);
    }
  }

  /// The same for long double, unless it is a pair of doubles, for _Float16 and for __fp16.
  ///
  ///     static_assert(q32_32(0.1L).raw() == 429496730);  // 429496729.6
  template <detail::other_float Float>
  requires(!Rules.moving) explicit constexpr number(Float value) noexcept(never_throws) {
    if constexpr (detail::narrow_float<Float>) {
      raw_ = number(static_cast<double>(value)).raw_;
    } else {
      raw_ = converted_in_integers(value);
    }
  }

  /// Converts a number of another format or policy. The policy of the result rounds excess fraction
  /// bits (policy::multiply) and handles overflow.
  ///
  ///     static_assert(q8_8(q16_16(1.5)) == q8_8(1.5));
  ///     static_assert(q8_8(q16_16::from_raw(128)) == q8_8::from_raw(1));  // a half goes up
  template <class OtherRaw, int OtherBits, policy OtherRules>
  requires(!std::same_as<OtherRaw, Raw> || OtherBits != FractionBits ||
           OtherRules != Rules) explicit constexpr number(number<OtherRaw, OtherBits, OtherRules>
                                                              other) noexcept(never_throws) {
    constexpr int up = FractionBits - OtherBits;
    using wide = detail::signed_t<detail::largest(
        detail::signed_bits<OtherRaw> + detail::larger(up, 1), detail::signed_bits<Raw>, 64)>;
    const wide value = detail::shift_right<Rules.multiply>(
        wide{other.raw()} << detail::larger(up, 0), detail::larger(-up, 0));
    raw_ = detail::narrow<Rules.range, raw_type>(
        value, [other] { detail::raise_overflow<OtherBits>("conversion", other.raw()); });
  }

  /// @cond
  // Conversions that do not compile. The pack, which is always empty, makes each of these a worse
  // match than an explicit conversion; so does volatile.
  template <class Type, class... Nothing>
  requires(sizeof...(Nothing) == 0 && (detail::integer<Type> || std::is_floating_point_v<Type> ||
                                       detail::is_half_float<Type>)) number(Type, Nothing...)
  FIXED_INSTEAD("conversions are explicit: write q16_16(value), or a literal such as 1.5_q16_16");
  template <class OtherRaw, int OtherBits, policy OtherRules, class... Nothing>
  requires(sizeof...(Nothing) == 0 &&
           !std::same_as<number<OtherRaw, OtherBits, OtherRules>, number>)
      number(number<OtherRaw, OtherBits, OtherRules>, Nothing...)
  FIXED_INSTEAD(
      "formats convert explicitly, as in q8_8(x), which rounds and handles overflow by its policy");
  template <class Type>
  requires(std::is_integral_v<Type> && !detail::integer<Type>) number(Type)
  FIXED_INSTEAD("bool and char are not numbers: convert to int, as in q16_16(int{b})");
  explicit number(const char*)
      FIXED_INSTEAD("text becomes a number by from_chars, >> or a literal such as 1.5_q16_16");
  template <class Type>
  requires(Rules.moving && (detail::integer<Type> || std::is_floating_point_v<Type>)) number(Type)
  FIXED_INSTEAD("policy::moving: write from_raw(n) for a stored integer, N(q16_16(n)) for a value");
  template <class Type>
  requires(Rules.moving&& std::is_arithmetic_v<Type> && !std::same_as<Type, bool>) explicit
  operator Type() const FIXED_INSTEAD(
      "policy::moving: write x.raw() for the stored integer, to_integer<rounding::floor>(x) "
      "or static_cast<double>(q16_16(x)) for the value");
  template <class = void>
  requires(Rules.moving) number& operator++()
      FIXED_INSTEAD("policy::moving: ++ adds 1: write x += N::from_raw(1), or x += N(1_q16_16)");
  template <class = void>
  requires(Rules.moving) number operator++(int)
      FIXED_INSTEAD("policy::moving: ++ adds 1: write x += N::from_raw(1), or x += N(1_q16_16)");
  template <class = void>
  requires(Rules.moving) number& operator--()
      FIXED_INSTEAD("policy::moving: -- takes 1: write x -= N::from_raw(1), or x -= N(1_q16_16)");
  template <class = void>
  requires(Rules.moving) number operator--(int)
      FIXED_INSTEAD("policy::moving: -- takes 1: write x -= N::from_raw(1), or x -= N(1_q16_16)");
  operator double() const volatile FIXED_INSTEAD(
      "conversions are explicit: write static_cast<double>(x), or static_cast<int>(x), which "
      "truncates");
  explicit operator bool() const FIXED_INSTEAD("a number is not a condition: write x != 0");
  /// @endcond

  /// The nearest double, ties to even, in every rounding mode of the processor. Exact if the number
  /// has at most 53 significant bits, as all numbers of 32 bits or less do.
  explicit constexpr operator double() const noexcept requires(!Rules.moving) {
    if constexpr (detail::bits_of<Raw> <= 32) {
      const double x =
          static_cast<double>(raw_) / static_cast<double>(std::int64_t{1} << FractionBits);
      if constexpr (std::is_signed_v<Raw>) return x;
      // Vectorised, unsigned integers become a difference, and zero is -0 when it rounds downward.
      return detail::bit_cast<double>(detail::bit_cast<std::uint64_t>(x) & ~std::uint64_t{0} >> 1);
    } else {
      return detail::to_float<double, FractionBits>(raw_);
    }
  }

  /// The nearest float, ties to even, in every rounding mode of the processor.
  explicit constexpr operator float() const noexcept requires(!Rules.moving) {
    return detail::to_float<float, FractionBits>(raw_);
  }

  /// The nearest long double: exact, unless it is no wider than double.
  explicit constexpr operator long double() const noexcept requires(!Rules.moving) {
    if constexpr (std::numeric_limits<long double>::digits < detail::bits_of<Raw>) {
      return static_cast<double>(*this);
    }
    constexpr int half = FractionBits / 2;
    return static_cast<long double>(raw_) / static_cast<long double>(std::uint64_t{1} << half) /
           static_cast<long double>(std::uint64_t{1} << (FractionBits - half));
  }

  /// The whole part, truncated toward zero, as from double. If Int is too small, the result is
  /// modulo 2^bits. See to_integer() for other roundings.
  ///
  ///     static_assert(static_cast<int>(q16_16(-1.5)) == -1);
  template <std::integral Int>
  requires(!std::same_as<Int, bool> && !Rules.moving) explicit constexpr operator Int()
      const noexcept {
    using wide = detail::signed_t<detail::larger(64, detail::signed_bits<Raw> + 1)>;
    using whole = std::conditional_t<std::is_signed_v<Raw>, std::int64_t, std::uint64_t>;
    return static_cast<Int>(
        static_cast<whole>(detail::shift_right<rounding::truncate>(wide{raw_}, FractionBits)));
  }

  /// Compares values for equality. Numbers of different types do not compare.
  friend constexpr bool operator==(number, number) noexcept = default;
  /// Orders by value.
  friend constexpr auto operator<=>(number, number) noexcept = default;

  /// The number itself.
  [[nodiscard]] constexpr number operator+() const noexcept { return *this; }

  /// The negative, exact. That of the lowest number overflows; the policy handles it.
  [[nodiscard]] constexpr number operator-() const noexcept(never_throws) {
    return from_raw(narrowed<Rules.range>(detail::exact_negative(raw_), "operator-", raw_));
  }

  /// The sum, exact. The policy handles overflow.
  [[nodiscard]] friend constexpr number operator+(number a, number b) noexcept(never_throws) {
    return a += b;
  }

  /// The difference, exact. The policy handles overflow.
  [[nodiscard]] friend constexpr number operator-(number a, number b) noexcept(never_throws) {
    return a -= b;
  }

  /// The product, rounded once by policy::multiply. The policy handles overflow.
  ///
  ///     constexpr auto unit = q16_16::from_raw(1);
  ///     static_assert(unit * q16_16(0.5) == unit && -unit * q16_16(0.5) == q16_16());
  [[nodiscard]] friend constexpr number operator*(number a,
                                                  number b) noexcept(multiply_never_throws) {
    return a *= b;
  }

  /// The quotient, rounded once by policy::divide. The policy handles overflow. If division by zero
  /// does not throw, it returns the end of the range with the numerator's sign; 0 / 0 is 0.
  /// divide_error corresponds to the processor's #DE; see policy::fault.
  ///
  ///     static_assert((q16_16(-2) / q16_16(3)).raw() == -43691);  // -43690.67
  ///     static_assert(q16_16(-1) / q16_16() == std::numeric_limits<q16_16>::lowest());
  [[nodiscard]] friend constexpr number operator/(number n,
                                                  number d) noexcept(divide_never_throws) {
    if constexpr (!divide_never_throws) {
      const detail::division end = detail::try_division<Raw, FractionBits, Rules>(n.raw_, d.raw_);
      if (end == detail::division::divide_error) {
        detail::raise<divide_error>("divide error", "operator/", operand{n.raw_}, operand{d.raw_});
      }
      if (end == detail::division::out_of_range) {
        detail::raise_overflow<FractionBits>("operator/", n.raw_, d.raw_);
      }
    }
    return from_raw(detail::single_divide<Raw, FractionBits, Rules>(n.raw_, d.raw_));
  }

  /// n - d * trunc(n / d), exact: the remainder has the sign of n. Division by zero is an error
  /// where operator/ makes it one; otherwise the remainder is 0.
  ///
  ///     static_assert(q16_16(-5.5) % q16_16(2) == q16_16(-1.5));
  [[nodiscard]] friend constexpr number operator%(number n,
                                                  number d) noexcept(divide_never_throws) {
    if (d.raw_ == 0) return remainder_by_zero(n, operand{d.raw_});
    using wide = detail::sum_t<Raw>;
    return from_raw(static_cast<raw_type>(wide{n.raw_} % wide{d.raw_}));
  }

  /// x * 2^places, exact. The policy handles overflow, as in x + x. A negative `places` shifts
  /// right. `places` has any integer type of 8 to 64 bits, and any value.
  [[nodiscard]] friend constexpr number operator<<(number x, int places) noexcept(never_throws) {
    if (places < 0) return x >> (places < -64 ? 64 : -places);
    return from_raw(
        narrowed<Rules.range>(detail::exact_shift_left(x.raw_, places), "operator<<", x.raw_));
  }

  /// x / 2^places toward -infinity, under every policy: the arithmetic shift of the stored integer.
  /// A negative `places` shifts left.
  ///
  ///     static_assert((q16_16::from_raw(-3) >> 1).raw() == -2 && (q16_16(3) >> 1) == q16_16(1.5));
  [[nodiscard]] friend constexpr number operator>>(number x, int places) noexcept(never_throws) {
    if (places < 0) return x << (places < -64 ? 64 : -places);
    constexpr int most = detail::bits_of<Raw> - 1;
    const Raw almost = static_cast<Raw>(x.raw_ >> (places < most ? places : most));
    return from_raw(places > most ? static_cast<Raw>(almost >> 1) : almost);
  }
  /// @cond
  // Without these, an unsigned or wider `places` is ambiguous under clang++, and g++ warns, because
  // a shift of built-in integers takes it as it is.
  template <detail::integer Int>
  [[nodiscard]] friend constexpr number operator<<(number x, Int places) noexcept(never_throws) {
    return x << detail::places_of(places);
  }
  template <detail::integer Int>
  [[nodiscard]] friend constexpr number operator>>(number x, Int places) noexcept(never_throws) {
    return x >> detail::places_of(places);
  }
  /// @endcond

  /// Adds b. If this throws, the number is unchanged and the error names operator+.
  FIXED_INLINE_UNOPTIMISED constexpr number& operator+=(number b) noexcept(never_throws) {
    raw_ = narrowed<Rules.range>(detail::exact_sum(raw_, b.raw_), "operator+", raw_, b.raw_);
    return *this;
  }
  /// Subtracts b. If this throws, the number is unchanged and the error names operator-.
  FIXED_INLINE_UNOPTIMISED constexpr number& operator-=(number b) noexcept(never_throws) {
    raw_ = narrowed<Rules.range>(detail::exact_difference(raw_, b.raw_), "operator-", raw_, b.raw_);
    return *this;
  }
  /// Multiplies by b. If this throws, the number is unchanged and the error names operator*.
  FIXED_INLINE_UNOPTIMISED constexpr number& operator*=(number b) noexcept(multiply_never_throws) {
    raw_ = narrowed<Rules.product_range()>(
        detail::rounded_product<FractionBits, Rules.multiply>(raw_, b.raw_), "operator*", raw_,
        b.raw_);
    return *this;
  }
  /// Divides by b. The number is unchanged if operator/ throws.
  constexpr number& operator/=(number b) noexcept(divide_never_throws) { return *this = *this / b; }
  /// The remainder of a division by b. The number is unchanged if operator% throws.
  constexpr number& operator%=(number b) noexcept(divide_never_throws) { return *this = *this % b; }
  /// Shifts left. The number is unchanged if operator<< throws.
  constexpr number& operator<<=(int places) noexcept(never_throws) {
    return *this = *this << places;
  }
  /// Shifts right. The number is unchanged if operator>> throws.
  constexpr number& operator>>=(int places) noexcept(never_throws) {
    return *this = *this >> places;
  }
  /// @cond
  constexpr number& operator<<=(detail::integer auto places) noexcept(never_throws) {
    return *this = *this << places;
  }
  constexpr number& operator>>=(detail::integer auto places) noexcept(never_throws) {
    return *this = *this >> places;
  }
  number& operator<<=(std::floating_point auto) = delete;
  number& operator>>=(std::floating_point auto) = delete;
  /// @endcond

  /// @name Integers
  /// An integer has its exact value, even if the type cannot represent it. An integer divided by a
  /// number does not compile: write q16_16(1) / x. bool and the character types do not mix with
  /// numbers.
  ///
  ///     static_assert(q16_16(1.5) * 2 == 3 && q8_8(0.5) * 200 == 100);
  ///     static_assert(q16_16(2) / 3 == q16_16::from_raw(43691));  // 43690.67
  ///     static_assert(q16_16(1.5) < 2 && q16_16(32767) < 40000);
  /// \{

  /// The sum, exact. The policy handles overflow.
  template <detail::value_integer<Rules> Int>
  [[nodiscard]] friend constexpr number operator+(number a, Int b) noexcept(never_throws) {
    return with_integer<Rules.range>(units(b) + a.raw_, "operator+", a, b);
  }
  template <detail::value_integer<Rules> Int>
  [[nodiscard]] friend constexpr number operator+(Int a, number b) noexcept(never_throws) {
    return with_integer<Rules.range>(units(a) + b.raw_, "operator+", a, b);
  }
  /// The difference, exact. The policy handles overflow.
  template <detail::value_integer<Rules> Int>
  [[nodiscard]] friend constexpr number operator-(number a, Int b) noexcept(never_throws) {
    return with_integer<Rules.range>(-units(b) + a.raw_, "operator-", a, b);
  }
  template <detail::value_integer<Rules> Int>
  [[nodiscard]] friend constexpr number operator-(Int a, number b) noexcept(never_throws) {
    return with_integer<Rules.range>(units(a) - b.raw_, "operator-", a, b);
  }
  /// The product, exact. The policy handles overflow.
  template <detail::value_integer<Rules> Int>
  [[nodiscard]] friend constexpr number operator*(number a, Int b) noexcept(multiply_never_throws) {
    return with_integer<Rules.product_range()>(factor(b) * a.raw_, "operator*", a, b);
  }
  template <detail::value_integer<Rules> Int>
  [[nodiscard]] friend constexpr number operator*(Int a, number b) noexcept(multiply_never_throws) {
    return with_integer<Rules.product_range()>(factor(a) * b.raw_, "operator*", a, b);
  }
  /// The quotient, rounded once by policy::divide. Division by 0 and overflow follow number /
  /// number.
  template <detail::value_integer<Rules> Int>
  [[nodiscard]] friend constexpr number operator/(number n, Int d) noexcept(divide_never_throws) {
    if (d == 0) return n / number();
    const auto quotient = detail::divide_by_integer<Rules.divide>(n.raw_, d);
    if constexpr (Rules.fault == divide_fault::signed_quotient) {
      if (!detail::fits<Raw>(quotient)) {
        detail::raise<divide_error>("divide error", "operator/", operand{n.raw_}, d);
      }
    }
    return with_integer<Rules.quotient_range()>(quotient, "operator/", n, d);
  }
  /// The remainder, exact, as number % number.
  template <detail::value_integer<Rules> Int>
  [[nodiscard]] friend constexpr number operator%(number n, Int d) noexcept(divide_never_throws) {
    if (d == 0) return remainder_by_zero(n, d);
    using wide = detail::units_t<Raw, FractionBits>;
    // A divisor beyond the range leaves n.
    const wide divisor = detail::units<Raw, FractionBits, overflow::saturate>(d);
    return from_raw(static_cast<raw_type>(wide{n.raw_} % divisor));
  }
  template <detail::value_integer<Rules> Int>
  constexpr number& operator%=(Int b) noexcept(divide_never_throws) {
    return *this = *this % b;
  }
  template <detail::value_integer<Rules> Int>
  constexpr number& operator+=(Int b) noexcept(never_throws) {
    return *this = *this + b;
  }
  template <detail::value_integer<Rules> Int>
  constexpr number& operator-=(Int b) noexcept(never_throws) {
    return *this = *this - b;
  }
  template <detail::value_integer<Rules> Int>
  constexpr number& operator*=(Int b) noexcept(multiply_never_throws) {
    return *this = *this * b;
  }
  template <detail::value_integer<Rules> Int>
  constexpr number& operator/=(Int b) noexcept(divide_never_throws) {
    return *this = *this / b;
  }

  /// Compares values, also with integers outside the range of the type.
  template <detail::value_integer<Rules> Int>
  friend constexpr bool operator==(number a, Int b) noexcept {
    return a <=> b == 0;
  }
  template <detail::value_integer<Rules> Int>
  friend constexpr std::strong_ordering operator<=>(number a, Int b) noexcept {
    using wide = detail::units_t<Raw, FractionBits>;
    const auto integer = detail::units<Raw, FractionBits, overflow::saturate>(b);
    const wide raw{a.raw_};
    return detail::ordering(raw < integer, integer < raw);
  }

  /// Adds 1. The policy handles overflow.
  constexpr number& operator++() noexcept(never_throws) requires(!Rules.moving) {
    return *this += 1;
  }
  constexpr number operator++(int) noexcept(never_throws) requires(!Rules.moving) {
    const number before = *this;
    ++*this;
    return before;
  }
  /// Subtracts 1. The policy handles overflow.
  constexpr number& operator--() noexcept(never_throws) requires(!Rules.moving) {
    return *this -= 1;
  }
  constexpr number operator--(int) noexcept(never_throws) requires(!Rules.moving) {
    const number before = *this;
    --*this;
    return before;
  }
  /// \}

 private:
  template <class Float>
  static constexpr raw_type converted_in_integers(Float value) noexcept(never_throws) {
    using wide =
        std::conditional_t<detail::binary_float<Float>,
                           detail::signed_t<detail::larger(64, 2 * detail::bits_of<raw_type>)>,
                           detail::wide_integer<3>>;
    using kind = typename detail::scaled_float<wide>::kind;
    const auto x = detail::scale<Rules.multiply, wide>(value, FractionBits);
    if (x.what == kind::finite || (x.what == kind::beyond && Rules.range == overflow::wrap)) {
      return detail::narrow<Rules.range, raw_type>(
          x.integer, [value] { detail::raise<overflow_error>("overflow", "conversion", value); });
    }
    if constexpr (Rules.range == overflow::trap) {
      if (x.what == kind::nan) detail::raise<domain_error>("domain error", "conversion", value);
      detail::raise<overflow_error>("overflow", "conversion", value);
    }
    if (x.what == kind::nan) return 0;
    return x.negative ? lowest : highest;
  }

  using operand = detail::operand<Raw, FractionBits>;

  static constexpr raw_type lowest = (std::numeric_limits<raw_type>::min)();
  static constexpr raw_type highest = (std::numeric_limits<raw_type>::max)();

  /// The value as a stored integer under rule Overflow. `operands` are stored integers; an error
  /// names the operation and shows them as values.
  template <overflow Overflow, class Wide, class... Operands>
  FIXED_ALWAYS_INLINE static constexpr raw_type narrowed(
      const Wide& value, const char* operation,
      const Operands&... operands) noexcept(Overflow != overflow::trap) {
    return detail::narrow<Overflow, raw_type>(
        value, [&] { detail::raise_overflow<FractionBits>(operation, operands...); });
  }

  static constexpr number remainder_by_zero(number n, auto d) noexcept(divide_never_throws) {
    if constexpr (!divide_never_throws) {
      detail::raise<divide_error>("divide error", "operator%", operand{n.raw_}, d);
    }
    return {};
  }

  /// An integer as a stored integer; see detail::units.
  static constexpr auto units(auto integer) noexcept {
    return detail::units<Raw, FractionBits, Rules.range>(integer);
  }

  static constexpr auto factor(auto integer) noexcept {
    return detail::factor<Raw, Rules.product_range()>(integer);
  }

  /// Applies the policy to a result. An error names the integer as it was given.
  template <overflow Overflow, class Wide, class First, class Second>
  static constexpr number with_integer(const Wide& value, const char* operation, First a,
                                       Second b) noexcept(Overflow != overflow::trap) {
    const auto described = [](auto x) {
      if constexpr (std::integral<decltype(x)>) {
        return x;
      } else {
        return operand{x.raw_};
      }
    };
    return from_raw(detail::narrow<Overflow, raw_type>(value, [&] {
      detail::raise<overflow_error>("overflow", operation, described(a), described(b));
    }));
  }

 public:
  /// The stored integer; use raw() and from_raw(). It is public because only a class without
  /// private members can be the type of a template argument:
  ///
  ///     using half = std::integral_constant<q16_16, q16_16(0.5)>;
  ///     static_assert(half::value * 2 == 1);
  raw_type raw_ = 0;
};

/// n / d, or nothing if operator/ would throw or the divisor is zero.
///
///     static_assert(try_divide(q16_16(1), q16_16(2)) == q16_16(0.5));
///     static_assert(!try_divide(q16_16(1), q16_16(0)));
///     static_assert(!try_divide(q16_16_i8088(1), q16_16_i8088(0.5)));  // the whole part is 0
template <class Raw, int FractionBits, policy Rules>
[[nodiscard]] constexpr std::optional<number<Raw, FractionBits, Rules>> try_divide(
    number<Raw, FractionBits, Rules> n, number<Raw, FractionBits, Rules> d) noexcept {
  if (detail::try_division<Raw, FractionBits, Rules>(n.raw(), d.raw()) != detail::division::done) {
    return std::nullopt;
  }
  return number<Raw, FractionBits, Rules>::from_raw(
      detail::single_divide<Raw, FractionBits, Rules>(n.raw(), d.raw()));
}

}  // namespace fixproof

#include "fixed/detail/refused.hpp"
#include "fixed/presets.hpp"
