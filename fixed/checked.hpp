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

template <class N, class Wide>
constexpr N wrapped(const Wide& value) noexcept {
  return N::from_raw(narrow<overflow::wrap, typename N::raw_type>(value, [] {}));
}

template <class N, class Wide>
constexpr N saturated_to(const Wide& value) noexcept {
  return N::from_raw(narrow<overflow::saturate, typename N::raw_type>(value, [] {}));
}

template <class N, class Wide>
constexpr overflowing<N> flagged(const Wide& value) noexcept {
  return {wrapped<N>(value), !fits<typename N::raw_type>(value)};
}

template <class N, class Wide>
constexpr std::optional<N> if_in_range(const Wide& value) noexcept {
  if (!fits<typename N::raw_type>(value)) return std::nullopt;
  return wrapped<N>(value);
}

/// Calls `done` with the rounded quotient, or `by_zero` with the value of n / 0.
template <class N, class Done, class ByZero>
constexpr auto with_quotient(N n, N d, const Done& done, const ByZero& by_zero) noexcept {
  using raw = typename N::raw_type;
  const auto divisor = effective_divisor<raw, N::fraction_bits, N::rules>(d.raw());
  if (divisor == divisor_t<raw>{0}) return by_zero(N::from_raw(limit_toward_zero(n.raw())));
  return done(quotient_of<raw, N::fraction_bits, N::rules>(n.raw(), divisor));
}

}  // namespace detail

/// @name a + b
/// \{

/// a + b.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_add(N a, N b) noexcept {
  return detail::if_in_range<N>(detail::exact_sum(a.raw(), b.raw()));
}
template <any_number N>
[[nodiscard]] constexpr overflowing<N> overflowing_add(N a, N b) noexcept {
  return detail::flagged<N>(detail::exact_sum(a.raw(), b.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N saturating_add(N a, N b) noexcept {
  return detail::saturated_to<N>(detail::exact_sum(a.raw(), b.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N wrapping_add(N a, N b) noexcept {
  return detail::wrapped<N>(detail::exact_sum(a.raw(), b.raw()));
}
/// \}

/// @name a - b
/// \{

/// a - b.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_subtract(N a, N b) noexcept {
  return detail::if_in_range<N>(detail::exact_difference(a.raw(), b.raw()));
}
template <any_number N>
[[nodiscard]] constexpr overflowing<N> overflowing_subtract(N a, N b) noexcept {
  return detail::flagged<N>(detail::exact_difference(a.raw(), b.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N saturating_subtract(N a, N b) noexcept {
  return detail::saturated_to<N>(detail::exact_difference(a.raw(), b.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N wrapping_subtract(N a, N b) noexcept {
  return detail::wrapped<N>(detail::exact_difference(a.raw(), b.raw()));
}
/// \}

/// @name a * b, rounded once by policy::multiply
/// \{

/// a * b, rounded once by policy::multiply.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_multiply(N a, N b) noexcept {
  return detail::if_in_range<N>(
      detail::rounded_product<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw()));
}
template <any_number N>
[[nodiscard]] constexpr overflowing<N> overflowing_multiply(N a, N b) noexcept {
  return detail::flagged<N>(
      detail::rounded_product<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N saturating_multiply(N a, N b) noexcept {
  return detail::saturated_to<N>(
      detail::rounded_product<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N wrapping_multiply(N a, N b) noexcept {
  return detail::wrapped<N>(
      detail::rounded_product<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw()));
}
/// \}

/// @name a * b + c, rounded once by policy::multiply
/// \{

/// a * b + c, rounded once by policy::multiply.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_mul_add(N a, N b, N c) noexcept {
  return detail::if_in_range<N>(
      detail::rounded_mul_add<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw(), c.raw()));
}
template <any_number N>
[[nodiscard]] constexpr overflowing<N> overflowing_mul_add(N a, N b, N c) noexcept {
  return detail::flagged<N>(
      detail::rounded_mul_add<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw(), c.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N saturating_mul_add(N a, N b, N c) noexcept {
  return detail::saturated_to<N>(
      detail::rounded_mul_add<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw(), c.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N wrapping_mul_add(N a, N b, N c) noexcept {
  return detail::wrapped<N>(
      detail::rounded_mul_add<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw(), c.raw()));
}
/// \}

/// @name -a
/// \{

/// -a.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_negate(N a) noexcept {
  return detail::if_in_range<N>(detail::exact_negative(a.raw()));
}
template <any_number N>
[[nodiscard]] constexpr overflowing<N> overflowing_negate(N a) noexcept {
  return detail::flagged<N>(detail::exact_negative(a.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N saturating_negate(N a) noexcept {
  return detail::saturated_to<N>(detail::exact_negative(a.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N wrapping_negate(N a) noexcept {
  return detail::wrapped<N>(detail::exact_negative(a.raw()));
}
/// \}

/// @name The absolute value of a
/// \{

/// The absolute value of a.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_abs(N a) noexcept {
  return detail::if_in_range<N>(detail::exact_magnitude(a.raw()));
}
template <any_number N>
[[nodiscard]] constexpr overflowing<N> overflowing_abs(N a) noexcept {
  return detail::flagged<N>(detail::exact_magnitude(a.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N saturating_abs(N a) noexcept {
  return detail::saturated_to<N>(detail::exact_magnitude(a.raw()));
}
template <any_number N>
[[nodiscard]] constexpr N wrapping_abs(N a) noexcept {
  return detail::wrapped<N>(detail::exact_magnitude(a.raw()));
}
/// \}

/// @name a * 2^places
/// \{

/// a * 2^places. A negative `places` shifts right, toward -infinity, as in a << places. Unlike
/// there, `places` is an int.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_shift_left(N a, int places) noexcept {
  return detail::if_in_range<N>(detail::exact_shift_left(a.raw(), places));
}
template <any_number N>
[[nodiscard]] constexpr overflowing<N> overflowing_shift_left(N a, int places) noexcept {
  return detail::flagged<N>(detail::exact_shift_left(a.raw(), places));
}
template <any_number N>
[[nodiscard]] constexpr N saturating_shift_left(N a, int places) noexcept {
  return detail::saturated_to<N>(detail::exact_shift_left(a.raw(), places));
}
template <any_number N>
[[nodiscard]] constexpr N wrapping_shift_left(N a, int places) noexcept {
  return detail::wrapped<N>(detail::exact_shift_left(a.raw(), places));
}
/// \}

/// @name n / d
/// \{

/// n / d, rounded once by policy::divide.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_divide(N n, N d) noexcept {
  return detail::with_quotient(
      n, d, [](const auto& quotient) { return detail::if_in_range<N>(quotient); },
      [](N) -> std::optional<N> { return std::nullopt; });
}
template <any_number N>
[[nodiscard]] constexpr overflowing<N> overflowing_divide(N n, N d) noexcept {
  return detail::with_quotient(
      n, d, [](const auto& quotient) { return detail::flagged<N>(quotient); },
      [](N limit) {
        return overflowing<N>{limit, true};
      });
}
template <any_number N>
[[nodiscard]] constexpr N saturating_divide(N n, N d) noexcept {
  return detail::with_quotient(
      n, d, [](const auto& quotient) { return detail::saturated_to<N>(quotient); },
      [](N limit) { return limit; });
}
template <any_number N>
[[nodiscard]] constexpr N wrapping_divide(N n, N d) noexcept {
  return detail::with_quotient(
      n, d, [](const auto& quotient) { return detail::wrapped<N>(quotient); },
      [](N limit) { return limit; });
}
/// \}

/// n % d, or nothing if d is zero. No other remainder overflows.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_remainder(N n, N d) noexcept {
  if (d.raw() == 0) return std::nullopt;
  return n % d;
}

/// The square root, or nothing for a negative number or a result out of range.
template <any_number N>
[[nodiscard]] constexpr std::optional<N> checked_sqrt(N x) noexcept {
  if (x.raw() < 0) return std::nullopt;
  using raw = typename N::raw_type;
  const auto root = detail::nearest_root<N::fraction_bits>(x.raw());
  if (!detail::fits<raw>(root)) return std::nullopt;
  return N::from_raw(static_cast<raw>(root));
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
  template <any_number N>
  [[nodiscard]] constexpr N add(N a, N b) noexcept {
    return keep(overflowing_add(a, b));
  }
  /// The wrapped difference; see overflowing_subtract().
  template <any_number N>
  [[nodiscard]] constexpr N subtract(N a, N b) noexcept {
    return keep(overflowing_subtract(a, b));
  }
  /// The wrapped product; see overflowing_multiply().
  template <any_number N>
  [[nodiscard]] constexpr N multiply(N a, N b) noexcept {
    return keep(overflowing_multiply(a, b));
  }
  /// The wrapped quotient; see overflowing_divide().
  template <any_number N>
  [[nodiscard]] constexpr N divide(N n, N d) noexcept {
    return keep(overflowing_divide(n, d));
  }
  /// Keeps the result of any overflowing_ function.
  template <any_number N>
  constexpr N keep(const overflowing<N>& result) noexcept {
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
