/// \file
/// The integers that mix with numbers, and their arithmetic.
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "fixed/detail/overflow.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// Every integer except bool and the character types, which a program rarely means as numbers.
template <class T>
concept integer =
    std::integral<T> && !std::same_as<std::remove_cv_t<T>, bool> &&
    !std::same_as<std::remove_cv_t<T>, char> && !std::same_as<std::remove_cv_t<T>, wchar_t> &&
    !std::same_as<std::remove_cv_t<T>, char8_t> && !std::same_as<std::remove_cv_t<T>, char16_t> &&
    !std::same_as<std::remove_cv_t<T>, char32_t>;

/// The integer for sums and products: modulo 2^32 if the policy wraps, else limited to a value that
/// leaves every range.
template <overflow O, integer Int>
constexpr std::int64_t factor(Int value) noexcept {
  if constexpr (O == overflow::wrap) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(value));
  } else {
    return clamp_far(value);
  }
}

/// raw / d rounded by rule R. \pre d is not zero
template <rounding R, integer Int>
constexpr std::int64_t divide_by_integer(std::int32_t raw, Int d) noexcept {
  // Every divisor of 34 bits or more rounds alike: the quotient is less than a half.
  const std::int64_t divisor = clamp_far<34>(d);
  const std::int64_t parts = 2 * (divisor < 0 ? -std::int64_t{raw} : std::int64_t{raw});
  const std::int64_t unit = 2 * (divisor < 0 ? -divisor : divisor);
  return floor_divide(parts + bias<R>(parts < 0, unit), unit);
}

}  // namespace fixproof::detail
