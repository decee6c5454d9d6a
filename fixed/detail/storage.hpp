/// @file
/// The integer types that store a number.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// Every integer of 8 to 64 bits except bool and the character types, which a program rarely means
/// as numbers.
template <class Type>
concept integer = std::integral<Type> && sizeof(Type) <= sizeof(std::uint64_t) &&
                  !std::same_as<std::remove_cv_t<Type>, bool> &&
                  !std::same_as<std::remove_cv_t<Type>, char> &&
                  !std::same_as<std::remove_cv_t<Type>, wchar_t> &&
                  !std::same_as<std::remove_cv_t<Type>, char8_t> &&
                  !std::same_as<std::remove_cv_t<Type>, char16_t> &&
                  !std::same_as<std::remove_cv_t<Type>, char32_t>;

/// The width of an integer, the sign included.
template <class Raw>
inline constexpr int bits_of = std::numeric_limits<Raw>::digits + (std::is_signed_v<Raw> ? 1 : 0);

/// The width of the narrowest signed integer that holds every Raw.
template <class Raw>
inline constexpr int signed_bits = std::numeric_limits<Raw>::digits + 1;

/// Holds the product of a RawA and a RawB, a term of a Sum: at most 64 bits if they hold it,
/// because processors of 32 bits add these to a wider sum with less work.
template <class RawA, class RawB, class Sum>
using term_t = std::conditional_t<(signed_bits<RawA> + signed_bits<RawB> <= 65),
                                  signed_t<signed_bits<RawA> + signed_bits<RawB> - 1>, Sum>;

/// Holds the product of two Raws, and that plus a half ulp.
template <class Raw>
using product_t = signed_t<2 * bits_of<Raw> + (std::is_signed_v<Raw> ? 0 : 1)>;

/// Holds a sum of a product_t and a Raw times 2^FractionBits, and that plus a half ulp.
template <class Raw, int FractionBits>
using mul_add_t = signed_t<2 * bits_of<Raw> + (!std::is_signed_v<Raw>             ? 2
                                               : FractionBits <= bits_of<Raw> - 2 ? 0
                                                                                  : 1)>;

}  // namespace fixproof::detail
