/// @file
/// Overflow as a value: four forms of every operation that can overflow, the same under every
/// policy.
///
/// checked_X returns nothing if the result is out of range or does not exist. overflowing_X returns
/// the wrapped result and whether the exact one is out of range. saturating_X returns the end of
/// the range instead, and wrapping_X reduces the result modulo the range. The policy decides only
/// how they round, and which part of a divisor counts. None of them throws.
///
///     static_assert(!checked_add(q16_16(32767), q16_16(1)));
///     static_assert(overflowing_add(q16_16(32767), q16_16(1)).overflow);
///     static_assert(saturating_multiply(q16_16(300), q16_16(-300)) == q16_16(-32768));
///     static_assert(wrapping_subtract(q16_16_trapping(-32768), q16_16_trapping(1)) == 32767);
///
/// A division by zero gives nothing, or the end of the range with the numerator's sign (0 / 0 is 0)
/// and `overflow`.
#pragma once

#include <optional>

#include "fixed/detail/divide.hpp"
#include "fixed/detail/exact.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"
#include "fixed/traits.hpp"

namespace fixproof {

/// A wrapped result, and whether the exact one is out of range or does not exist.
template <class Number>
struct overflowing {
  Number value;           ///< The result modulo the range.
  bool overflow = false;  ///< Whether the result is out of range or does not exist.

  /// Whether both members are equal.
  friend constexpr bool operator==(const overflowing&, const overflowing&) = default;
};

namespace detail {

template <class Number, class Wide>
constexpr Number wrapped(const Wide& value) noexcept {
  return Number::from_raw(narrow<overflow::wrap, typename Number::raw_type>(value, [] {}));
}

template <class Number, class Wide>
constexpr Number saturated_to(const Wide& value) noexcept {
  return Number::from_raw(narrow<overflow::saturate, typename Number::raw_type>(value, [] {}));
}

template <class Number, class Wide>
constexpr overflowing<Number> flagged(const Wide& value) noexcept {
  return {wrapped<Number>(value), !fits<typename Number::raw_type>(value)};
}

template <class Number, class Wide>
constexpr std::optional<Number> if_in_range(const Wide& value) noexcept {
  if (!fits<typename Number::raw_type>(value)) return std::nullopt;
  return wrapped<Number>(value);
}

/// Calls `done` with the rounded quotient, or `by_zero` with the value of n / 0.
template <class Number, class Done, class ByZero>
constexpr auto with_quotient(Number n, Number d, const Done& done, const ByZero& by_zero) noexcept {
  using raw = typename Number::raw_type;
  const auto divisor = effective_divisor<raw, Number::fraction_bits, Number::rules>(d.raw());
  if (divisor == divisor_t<raw>{0}) return by_zero(Number::from_raw(limit_toward_zero(n.raw())));
  return done(quotient_of<raw, Number::fraction_bits, Number::rules>(n.raw(), divisor));
}

}  // namespace detail

/// @name a + b
/// \{

/// a + b.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_add(Number a, Number b) noexcept {
  return detail::if_in_range<Number>(detail::exact_sum(a.raw(), b.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr overflowing<Number> overflowing_add(Number a, Number b) noexcept {
  return detail::flagged<Number>(detail::exact_sum(a.raw(), b.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number saturating_add(Number a, Number b) noexcept {
  return detail::saturated_to<Number>(detail::exact_sum(a.raw(), b.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number wrapping_add(Number a, Number b) noexcept {
  return detail::wrapped<Number>(detail::exact_sum(a.raw(), b.raw()));
}
/// \}

/// @name a - b
/// \{

/// a - b.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_subtract(Number a, Number b) noexcept {
  return detail::if_in_range<Number>(detail::exact_difference(a.raw(), b.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr overflowing<Number> overflowing_subtract(Number a, Number b) noexcept {
  return detail::flagged<Number>(detail::exact_difference(a.raw(), b.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number saturating_subtract(Number a, Number b) noexcept {
  return detail::saturated_to<Number>(detail::exact_difference(a.raw(), b.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number wrapping_subtract(Number a, Number b) noexcept {
  return detail::wrapped<Number>(detail::exact_difference(a.raw(), b.raw()));
}
/// \}

/// @name a * b, rounded once by policy::multiply
/// \{

/// a * b, rounded once by policy::multiply.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_multiply(Number a, Number b) noexcept {
  return detail::if_in_range<Number>(
      detail::rounded_product<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr overflowing<Number> overflowing_multiply(Number a, Number b) noexcept {
  return detail::flagged<Number>(
      detail::rounded_product<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number saturating_multiply(Number a, Number b) noexcept {
  return detail::saturated_to<Number>(
      detail::rounded_product<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number wrapping_multiply(Number a, Number b) noexcept {
  return detail::wrapped<Number>(
      detail::rounded_product<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw()));
}
/// \}

/// @name a * b + c, rounded once by policy::multiply
/// \{

/// a * b + c, rounded once by policy::multiply.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_mul_add(Number a, Number b,
                                                              Number c) noexcept {
  return detail::if_in_range<Number>(
      detail::rounded_mul_add<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw(),
                                                                             c.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr overflowing<Number> overflowing_mul_add(Number a, Number b,
                                                                Number c) noexcept {
  return detail::flagged<Number>(
      detail::rounded_mul_add<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw(),
                                                                             c.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number saturating_mul_add(Number a, Number b, Number c) noexcept {
  return detail::saturated_to<Number>(
      detail::rounded_mul_add<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw(),
                                                                             c.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number wrapping_mul_add(Number a, Number b, Number c) noexcept {
  return detail::wrapped<Number>(
      detail::rounded_mul_add<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw(),
                                                                             c.raw()));
}
/// \}

/// @name -a
/// \{

/// -a.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_negate(Number a) noexcept {
  return detail::if_in_range<Number>(detail::exact_negative(a.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr overflowing<Number> overflowing_negate(Number a) noexcept {
  return detail::flagged<Number>(detail::exact_negative(a.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number saturating_negate(Number a) noexcept {
  return detail::saturated_to<Number>(detail::exact_negative(a.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number wrapping_negate(Number a) noexcept {
  return detail::wrapped<Number>(detail::exact_negative(a.raw()));
}
/// \}

/// @name The absolute value of a
/// \{

/// The absolute value of a.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_abs(Number a) noexcept {
  return detail::if_in_range<Number>(detail::exact_magnitude(a.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr overflowing<Number> overflowing_abs(Number a) noexcept {
  return detail::flagged<Number>(detail::exact_magnitude(a.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number saturating_abs(Number a) noexcept {
  return detail::saturated_to<Number>(detail::exact_magnitude(a.raw()));
}
template <any_number Number>
[[nodiscard]] constexpr Number wrapping_abs(Number a) noexcept {
  return detail::wrapped<Number>(detail::exact_magnitude(a.raw()));
}
/// \}

/// @name a * 2^places
/// \{

/// a * 2^places. A negative `places` shifts right, toward -infinity, as in a << places. Unlike
/// there, `places` is an int.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_shift_left(Number a, int places) noexcept {
  return detail::if_in_range<Number>(detail::exact_shift_left(a.raw(), places));
}
template <any_number Number>
[[nodiscard]] constexpr overflowing<Number> overflowing_shift_left(Number a, int places) noexcept {
  return detail::flagged<Number>(detail::exact_shift_left(a.raw(), places));
}
template <any_number Number>
[[nodiscard]] constexpr Number saturating_shift_left(Number a, int places) noexcept {
  return detail::saturated_to<Number>(detail::exact_shift_left(a.raw(), places));
}
template <any_number Number>
[[nodiscard]] constexpr Number wrapping_shift_left(Number a, int places) noexcept {
  return detail::wrapped<Number>(detail::exact_shift_left(a.raw(), places));
}
/// \}

/// @name n / d
/// \{

/// n / d, rounded once by policy::divide.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_divide(Number n, Number d) noexcept {
  return detail::with_quotient(
      n, d, [](const auto& quotient) { return detail::if_in_range<Number>(quotient); },
      [](Number) -> std::optional<Number> { return std::nullopt; });
}
template <any_number Number>
[[nodiscard]] constexpr overflowing<Number> overflowing_divide(Number n, Number d) noexcept {
  return detail::with_quotient(
      n, d, [](const auto& quotient) { return detail::flagged<Number>(quotient); },
      [](Number limit) {
        return overflowing<Number>{limit, true};
      });
}
template <any_number Number>
[[nodiscard]] constexpr Number saturating_divide(Number n, Number d) noexcept {
  return detail::with_quotient(
      n, d, [](const auto& quotient) { return detail::saturated_to<Number>(quotient); },
      [](Number limit) { return limit; });
}
template <any_number Number>
[[nodiscard]] constexpr Number wrapping_divide(Number n, Number d) noexcept {
  return detail::with_quotient(
      n, d, [](const auto& quotient) { return detail::wrapped<Number>(quotient); },
      [](Number limit) { return limit; });
}
/// \}

/// n % d, or nothing if d is zero. No other remainder overflows.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_remainder(Number n, Number d) noexcept {
  if (d.raw() == 0) return std::nullopt;
  return n % d;
}

/// The square root, or nothing for a negative number or a result out of range.
template <any_number Number>
[[nodiscard]] constexpr std::optional<Number> checked_sqrt(Number x) noexcept {
  if (x.raw() < 0) return std::nullopt;
  using raw = typename Number::raw_type;
  const auto root = detail::stored_root<Number::rules.functions, Number::fraction_bits>(x.raw());
  if (!detail::fits<raw>(root)) return std::nullopt;
  return Number::from_raw(static_cast<raw>(root));
}

/// Remembers whether any result of a block of code was out of range or did not exist.
///
///     static_assert([] {
///       sticky_status status;
///       const q16_16 area = status.multiply(q16_16(300), q16_16(300));
///       const q16_16 half = status.divide(area, q16_16(2));
///       return status.overflow() && half == area / 2;  // tested once, at the end
///     }());
class sticky_status {
 public:
  /// The wrapped sum; see overflowing_add().
  template <any_number Number>
  [[nodiscard]] constexpr Number add(Number a, Number b) noexcept {
    return keep(overflowing_add(a, b));
  }
  /// The wrapped difference; see overflowing_subtract().
  template <any_number Number>
  [[nodiscard]] constexpr Number subtract(Number a, Number b) noexcept {
    return keep(overflowing_subtract(a, b));
  }
  /// The wrapped product; see overflowing_multiply().
  template <any_number Number>
  [[nodiscard]] constexpr Number multiply(Number a, Number b) noexcept {
    return keep(overflowing_multiply(a, b));
  }
  /// The wrapped quotient; see overflowing_divide().
  template <any_number Number>
  [[nodiscard]] constexpr Number divide(Number n, Number d) noexcept {
    return keep(overflowing_divide(n, d));
  }
  /// Keeps the result of any overflowing_ function.
  template <any_number Number>
  constexpr Number keep(const overflowing<Number>& result) noexcept {
    overflow_ = overflow_ || result.overflow;
    return result.value;
  }

  /// Whether any result since the last clear() was not the exact one, rounded.
  [[nodiscard]] constexpr bool overflow() const noexcept { return overflow_; }
  /// Begins anew.
  constexpr void clear() noexcept { overflow_ = false; }

 private:
  bool overflow_ = false;
};

}  // namespace fixproof
