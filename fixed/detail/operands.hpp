/// @file
/// Operands that the functions of real numbers do not take, and what to write instead.
#pragma once

#include <concepts>
#include <type_traits>

#include "fixed/detail/instead.hpp"
#include "fixed/number.hpp"

namespace fixproof::detail {

/// Whether functions of these numbers are computed with intervals: if 64-bit integers are too short
/// for the first try, or the results are bounds.
template <class To, class... Number>
inline constexpr bool needs_intervals = To::rules.functions != rounding::nearest ||
                                        bits_of<typename To::raw_type> > 32 ||
                                        ((bits_of<typename Number::raw_type> > 32) || ...);

template <class Type>
concept number_or_arithmetic = std::is_arithmetic_v<Type> || is_plain_number<Type>;

template <class... Type>
concept has_number = (is_plain_number<Type> || ...);

/// Whether a function of numbers of one type would have to convert some of its operands.
template <class First, class... Second>
concept mixed_operands = has_number<First, Second...> && !(std::same_as<First, Second> && ...);

/// An operand that is not a number. A conversion of the standard is preferred to this one, so that
/// the C library's function remains the better match wherever it is visible.
struct no_number {
  // NOLINTNEXTLINE(google-explicit-constructor): takes an operand
  no_number(std::integral auto /*operand*/) noexcept {}
  // NOLINTNEXTLINE(google-explicit-constructor): likewise
  no_number(std::floating_point auto /*operand*/) noexcept {}
};

}  // namespace fixproof::detail

// NOLINTBEGIN(cppcoreguidelines-macro-usage): these put the name of a function into a text
/// Refuses an operand that is not a number.
#define FIXED_REFUSED_PLAIN(name)                    \
  template <int = 0>                                 \
  fixproof::q16_16 name(fixproof::detail::no_number) \
      FIXED_INSTEAD(#name " takes a number: convert, as in " #name "(q16_16(0.5))");

/// Refuses operands of different types.
#define FIXED_REFUSED_MIX(name)                                                                \
  template <fixproof::detail::number_or_arithmetic First,                                      \
            fixproof::detail::number_or_arithmetic Second,                                     \
            fixproof::detail::number_or_arithmetic... Third>                                   \
  requires fixproof::detail::mixed_operands<First, Second, Third...> First name(First, Second, \
                                                                                Third...)      \
  FIXED_INSTEAD(#name " takes numbers of one type: convert, as in q16_16(2)");
// NOLINTEND(cppcoreguidelines-macro-usage)
