/// \file
/// Operands that the functions of real numbers do not take, and what to write instead.
#pragma once

#include <concepts>
#include <type_traits>

#include "fixed/detail/instead.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"

namespace fixproof::detail {

/// Whether the functions cover the format.
template <class Number>
inline constexpr bool has_functions = bits_of<typename Number::raw_type> <= 32;

/// Whether a function of two numbers of one type would have to convert one of the operands: a
/// number, and a number of another type or an arithmetic type.
template <class A, class B>
concept mixed_operands =
    !std::same_as<A, B> && ((is_number<A> && (is_number<B> || std::is_arithmetic_v<B>)) ||
                            (is_number<B> && std::is_arithmetic_v<A>));

}  // namespace fixproof::detail

// NOLINTBEGIN(cppcoreguidelines-macro-usage): these put the name of a function into a text
/// Refuses a format that function `name` does not cover.
#define FIXED_NEEDS_32_BITS(name, ...)                        \
  static_assert(fixproof::detail::has_functions<__VA_ARGS__>, \
                #name " needs a format of at most 32 bits: convert, as in q16_16(x)")

/// Refuses a double. Takes no other arithmetic type, so that the C library's function remains the
/// better match wherever it is visible.
#define FIXED_REFUSED_DOUBLE(name)  \
  template <std::same_as<double> T> \
  T name(T) FIXED_INSTEAD(#name " takes a number: convert, as in " #name "(q16_16(0.5))");

/// Refuses two operands of different types.
#define FIXED_REFUSED_PAIR(name)                                              \
  template <class A, class B>                                                 \
  requires fixproof::detail::mixed_operands<A, B> A name(A, B)                \
  FIXED_INSTEAD(#name " takes two numbers of one type: convert, as in " #name \
                      "(q16_16(x), q16_16(2))");
// NOLINTEND(cppcoreguidelines-macro-usage)
