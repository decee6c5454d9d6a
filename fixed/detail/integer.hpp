/// @file
/// Arithmetic with the integers that mix with numbers.
#pragma once

#include <cstdint>
#include <type_traits>

#include "fixed/detail/overflow.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// An integer that mixes with numbers of the policy, and converts to and from them.
template <class Type, policy Rules>
concept value_integer = integer<Type> && !Rules.moving;

/// An integer as a Wide: modulo the range of Raw if the rule is to wrap, else limited to
/// +-(2^Limit - 1) unless Raw has 64 bits.
template <class Wide, class Raw, overflow Overflow, int Limit, integer Int>
constexpr Wide reduced(Int value) noexcept {
  if constexpr (Overflow == overflow::wrap) {
    return Wide{static_cast<Raw>(static_cast<std::make_unsigned_t<Raw>>(value))};
  } else if constexpr (bits_of<Raw> == 64) {
    return Wide{value};
  } else {
    return Wide{clamp_far<Limit>(value)};
  }
}

/// Holds the product of a factor() and a Raw.
template <class Raw>
using factor_product_t = signed_t<larger(64, 2 * bits_of<Raw> + (std::is_signed_v<Raw> ? 0 : 2))>;

/// An integer for products. The limit is outside every range of Raw.
template <class Raw, overflow Overflow, integer Int>
constexpr factor_product_t<Raw> factor(Int value) noexcept {
  constexpr int limit = std::is_signed_v<Raw> ? 32 : 33;
  return reduced<factor_product_t<Raw>, Raw, Overflow, limit>(value);
}

/// Holds the sum of units() and a Raw.
template <class Raw, int FractionBits>
using units_t = signed_t<larger(64, (bits_of<Raw> == 64 ? 66 : 36) + FractionBits)>;

/// An integer in units of 2^-FractionBits, for sums. At the limit, every sum is out of range.
template <class Raw, int FractionBits, overflow Overflow, integer Int>
constexpr auto units(Int value) noexcept {
  return reduced<units_t<Raw, FractionBits>, Raw, Overflow, 34>(value) << FractionBits;
}

/// raw / d rounded by rule Rounding. @pre d is not zero
template <rounding Rounding, class Raw, integer Int>
constexpr auto divide_by_integer(Raw raw, Int d) noexcept {
  if constexpr (bits_of<Raw> == 64) {
    using wide = signed_t<66>;
    return rounded_ratio<Rounding>(wide{raw}, wide{d});
  } else {
    // Every divisor of 34 bits or more gives the same result: the quotient is less than a half.
    return rounded_ratio<Rounding>(std::int64_t{raw}, clamp_far<34>(d));
  }
}

}  // namespace fixproof::detail
