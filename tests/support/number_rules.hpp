/// @file
/// Rounding, overflow and division by the definition of every rule in fixed/policy.hpp, from exact
/// integers of any class. It shares only the names of the rules with fixed/, and nothing with
/// x86model/ and oracle/.
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>

#include "fixed/policy.hpp"

namespace exact {

/// n / d rounded down. @pre d > 0
template <class Int>
constexpr Int below(const Int& n, const std::type_identity_t<Int>& d) {
  const Int quotient = n / d;
  return quotient * d > n ? quotient - 1 : quotient;
}

/// n / d rounded by the rule. @pre d > 0
template <class Int>
constexpr Int round(const Int& n, const std::type_identity_t<Int>& d, fixproof::rounding rule) {
  using fixproof::rounding;
  const Int low = below(n, d);
  const Int twice = 2 * (n - low * d);
  if (twice == 0) return low;
  if (rule == rounding::floor) return low;
  if (rule == rounding::ceiling) return low + 1;
  if (rule == rounding::truncate) return n < 0 ? low + 1 : low;
  if (twice != d) return twice < d ? low : low + 1;
  const bool up = rule == rounding::half_up || (rule == rounding::half_away && n > 0) ||
                  (rule == rounding::half_even && low % 2 != 0);
  return up ? low + 1 : low;
}

/// A number type at run time, so that what is expected of it is compiled once and not for each of
/// dozens of types.
template <class Int>
struct NumberType {
  constexpr NumberType(std::size_t width, bool has_sign, int fraction, const fixproof::policy& own)
      : size(width),
        is_signed(has_sign),
        fraction_bits(fraction),
        rules(own),
        one(Int(1) << fraction),
        count(Int(1) << bits()),
        lowest(has_sign ? -(count / 2) : Int(0)),
        highest(lowest + count - 1) {}
  template <class N>
  static constexpr NumberType of() {
    return {sizeof(N), std::is_signed_v<typename N::raw_type>, N::fraction_bits, N::rules};
  }

  std::size_t size;
  bool is_signed;
  int fraction_bits;
  fixproof::policy rules;
  Int one;      ///< The stored integer of 1, which may be out of range.
  Int count;    ///< Of stored integers.
  Int lowest;   ///< Stored integer.
  Int highest;  ///< Stored integer.

  [[nodiscard]] constexpr int bits() const { return static_cast<int>(8 * size); }
  [[nodiscard]] constexpr bool fits(const Int& x) const { return x >= lowest && x <= highest; }
  [[nodiscard]] constexpr Int wrapped(const Int& x) const {
    return x - count * below(x - lowest, count);
  }
};

enum class Fault { none, divide_error, overflow, domain_error };

/// The stored integer of one result, and its fault.
template <class Int>
struct Result {
  Int raw;
  Fault fault = Fault::none;
};

/// An exact result in units of the type, wrapped if the rule throws.
template <class Int>
constexpr Result<Int> narrowed(const NumberType<Int>& type, const std::type_identity_t<Int>& value,
                               fixproof::overflow rule) {
  using fixproof::overflow;
  if (type.fits(value)) return {value};
  if (rule == overflow::wrap) return {type.wrapped(value)};
  if (rule == overflow::trap) return {type.wrapped(value), Fault::overflow};
  return {value < 0 ? type.lowest : type.highest, Fault::overflow};
}

/// n / d in units of the type, of any size; nothing if no part of d is used.
template <class Int>
constexpr std::optional<Int> unreduced_quotient(const NumberType<Int>& type, Int n, Int d,
                                                fixproof::rounding rule) {
  if (type.rules.divisor == fixproof::divisor_width::whole_part) {
    d /= type.one;
  } else {
    n *= type.one;
  }
  if (d == 0) return std::nullopt;
  return d < 0 ? round<Int>(-n, -d, rule) : round<Int>(n, d, rule);
}

/// n / d by the rules of the type. Without a divisor, the end of the range on the side of n.
template <class Int>
constexpr Result<Int> policy_quotient(const NumberType<Int>& type, const Int& n, const Int& d) {
  using fixproof::divide_fault;
  const std::optional<Int> value = unreduced_quotient(type, n, d, type.rules.divide);
  if (!value) {
    return {n == 0 ? n : n < 0 ? type.lowest : type.highest, Fault::divide_error};
  }
  Result<Int> result = narrowed(type, *value, type.rules.quotient_range());
  if (type.rules.fault == divide_fault::unsigned_quotient) {
    const Int cut = *unreduced_quotient(type, n, d, fixproof::rounding::truncate);
    if (cut <= -type.count || cut >= type.count) result.fault = Fault::divide_error;
  }
  if (type.rules.fault == divide_fault::signed_quotient && !type.fits(*value)) {
    result.fault = Fault::divide_error;
  }
  return result;
}

/// What an operation returns that has this result and overflow rule: nothing for an error.
template <class Int>
constexpr std::optional<Int> returned(const NumberType<Int>& type, const Result<Int>& result,
                                      fixproof::overflow rule) {
  const bool is_divide_fault =
      result.fault == Fault::divide_error && type.rules.fault != fixproof::divide_fault::none;
  if (is_divide_fault || (result.fault != Fault::none && rule == fixproof::overflow::trap)) {
    return std::nullopt;
  }
  return result.raw;
}

}  // namespace exact
