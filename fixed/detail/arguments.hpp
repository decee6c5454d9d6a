/// @file
/// What a number asks of its template arguments.
#pragma once

#include <limits>
#include <type_traits>

#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// True, unless it does not compile. A number asserts it.
template <class Raw, int FractionBits, policy Rules>
constexpr bool are_number_arguments() noexcept {
  static_assert(integer<Raw> && !std::is_const_v<Raw> && !std::is_volatile_v<Raw>,
                "the stored integer of a fixproof::number is an integer of 8 to 64 bits, such as "
                "std::int32_t; bool and character types are none");
  static_assert(FractionBits >= 0 && FractionBits <= bits_of<Raw>,
                "a fixproof::number has 0 to as many fraction bits as its stored integer has bits");
  static_assert(Rules.range != overflow::as_range,
                "policy::range is wrap, saturate or trap; as_range is for products and quotients");
  static_assert(Rules.multiply != rounding::nearest && Rules.divide != rounding::nearest,
                "policy::multiply and policy::divide say where ties go, as half_up does; "
                "rounding::nearest is for policy::functions");
  static_assert(!is_to_nearest<Rules.functions> || Rules.functions == rounding::nearest,
                "policy::functions is nearest, floor, ceiling or truncate");
  static_assert(
      Rules.fault != divide_fault::signed_quotient || Rules.quotients == overflow::as_range,
      "policy::fault = signed_quotient makes every quotient out of range an error, so "
      "policy::quotients has no effect; leave it out");
  static_assert(
      Rules.divisor == divisor_width::full || FractionBits < std::numeric_limits<Raw>::digits,
      "a number without whole bits has only 0 as the whole part of a divisor; use "
      "divisor_width::full");
  return true;
}

}  // namespace fixproof::detail
