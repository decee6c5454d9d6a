/// @file
/// What generic code asks about a number type: whether a type is one, and std::common_type.
#pragma once

#include <type_traits>

#include "fixed/detail/storage.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"

namespace fixproof {

/// Whether Type is a fixproof::number of any format and policy, const or not. A reference to one is
/// not.
///
///     static_assert(is_number_v<q16_16> && is_number_v<const q2_62> && !is_number_v<int>);
template <class Type>
inline constexpr bool is_number_v = detail::is_number<std::remove_cv_t<Type>>;

/// A fixproof::number of any format and policy.
///
///     const auto twice = [](any_number auto x) { return x + x; };
///     static_assert(twice(q16_16(1.5)) == 3 && twice(u8_8(100)) == 200);
template <class Type>
concept any_number = is_number_v<Type>;

}  // namespace fixproof

/// The common type of a number and an integer is the number, as is the result of their arithmetic.
/// Two different number types have none, because formats mix only through named functions such as
/// fixproof::add. Neither have a number and a bool, a character type or a floating-point type.
///
///     static_assert(std::is_same_v<std::common_type_t<q16_16, int>, q16_16>);
///     static_assert(std::is_same_v<std::common_type_t<long, q8_8, int>, q8_8>);
template <class Raw, int FractionBits, fixproof::policy Rules,
          fixproof::detail::value_integer<Rules> Int>
struct std::common_type<fixproof::number<Raw, FractionBits, Rules>, Int> {
  /// The number.
  using type = fixproof::number<Raw, FractionBits, Rules>;
};

/// The same, with the integer first.
template <class Int, class Raw, int FractionBits, fixproof::policy Rules>
requires fixproof::detail::value_integer<Int, Rules>
struct std::common_type<Int, fixproof::number<Raw, FractionBits, Rules>> {
  /// The number.
  using type = fixproof::number<Raw, FractionBits, Rules>;
};
