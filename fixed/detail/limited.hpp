/// @file
/// Makes the integers of fixed/detail results of functions, with limits and errors.
#pragma once

#include <cstdint>
#include <limits>

#include "fixed/detail/operands.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/result.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/number.hpp"

namespace fixproof::detail {

/// The rule of functions: policy::functions, or to nearest with the ties of the policy's products,
/// which go up if those are not to nearest.
template <class Number>
inline constexpr rounding rounding_of =
    Number::rules.functions != rounding::nearest ? Number::rules.functions
    : is_to_nearest<Number::rules.multiply>      ? Number::rules.multiply
                                                 : rounding::half_up;

/// The number of ulps as a Number. Out of range, throws an overflow_error under overflow::trap,
/// else returns the nearest limit. @param operands numbers of any formats, for the text of an error
template <class Number, class Ulps, class... Operands>
constexpr Number limited(const Ulps& ulps, const char* function,
                         Operands... operands) noexcept(Number::never_throws) {
  return narrowed_to<Number, function_range<Number::rules.range>>(ulps, function, operands...);
}

/// The result outside a function's domain: throws a domain_error under overflow::trap, else returns
/// `instead`.
template <class Number, class... Operands>
constexpr Number outside_domain(typename Number::raw_type instead, const char* function,
                                Operands... operands) noexcept(Number::never_throws) {
  if constexpr (Number::rules.range == overflow::trap) {
    raise<domain_error>(
        "domain error", function,
        operand<typename Operands::raw_type, Operands::fraction_bits>{operands.raw()}...);
  }
  return Number::from_raw(instead);
}

}  // namespace fixproof::detail
