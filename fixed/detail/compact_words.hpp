/// @file
/// Products, series, divisions and roundings that the compact functions share.
///
/// They take the steps of the functions in words with all terms of each series, each step rounded
/// alike. But every step is a loop or a call. A Cortex-M0 has products
/// of 32 bits, and each product of 64 bits that is inlined takes a tenth of a kilobyte.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/digit_series.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/nearest.hpp"
#include "fixed/detail/variant.hpp"

namespace fixproof::detail::in_compact_words {

using in_digits::undecided;

/// The product of two words of 32 bits.
FIXED_NOINLINE constexpr std::uint64_t product_of(std::uint32_t a, std::uint32_t b) noexcept {
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
  // The compiler would call its product of 64 by 64 bits, which takes twice the time.
  const std::uint32_t a0 = a & 0xffff;
  const std::uint32_t a1 = a >> 16;
  const std::uint32_t b0 = b & 0xffff;
  const std::uint32_t b1 = b >> 16;
  const std::uint32_t low = a0 * b0;
  const std::uint32_t middle = a0 * b1 + (low >> 16);
  const std::uint32_t sum = a1 * b0 + (middle & 0xffff);
  return std::uint64_t{a1 * b1 + (middle >> 16) + (sum >> 16)} << 32 | sum << 16 | (low & 0xffff);
#else
  return std::uint64_t{a} * b;
#endif
}

/// floor(a * b / 2^64).
FIXED_NOINLINE constexpr std::uint64_t high_product(std::uint64_t a, std::uint64_t b) noexcept {
  const auto a0 = static_cast<std::uint32_t>(a);
  const auto a1 = static_cast<std::uint32_t>(a >> 32);
  const auto b0 = static_cast<std::uint32_t>(b);
  const auto b1 = static_cast<std::uint32_t>(b >> 32);
  const std::uint64_t middle = product_of(a1, b0) + (product_of(a0, b0) >> 32);
  // The last coefficients of each series are this small.
  if (b1 == 0) return middle >> 32;
  const std::uint64_t sum = product_of(a0, b1) + static_cast<std::uint32_t>(middle);
  return product_of(a1, b1) + (middle >> 32) + (sum >> 32);
}

/// x times sum_of_series() of all coefficients, or of sum_of_alternating_series(), in units of
/// 2^-64.
FIXED_NOINLINE constexpr std::uint64_t series_of(const std::uint64_t* coefficients,
                                                 std::size_t terms, std::uint64_t x,
                                                 bool alternates) noexcept {
  std::uint64_t product = 0;
  while (terms-- > 0) {
    const std::uint64_t c = coefficients[terms];
    product = high_product(x, alternates ? c - product : c + product);
  }
  return product;
}

/// floor(rest * 2^bits / divisor). The remainder is left in `rest`. For a ratio of 1, all bits of
/// the quotient are 1, and the divisor is left. @pre rest <= divisor, rest < 2^63,
/// divisor <= 2^63 and 0 < bits <= 32
FIXED_NOINLINE constexpr std::uint32_t take_quotient(std::uint64_t& rest, std::uint64_t divisor,
                                                     int bits) noexcept {
  FIXED_ASSERT(rest <= divisor && rest >> 63 == 0 && (divisor - 1) >> 63 == 0);
  FIXED_ASSERT(bits > 0 && bits <= 32);
  std::uint64_t left = rest;
  // A bit above those of the quotient leaves the word when the last of them comes.
  std::uint32_t quotient = std::uint32_t{1} << (32 - bits);
  bool is_last = false;
  do {
    is_last = quotient >> 31 != 0;
    quotient <<= 1;
    left <<= 1;
    const std::uint64_t less = left - divisor;
    if (static_cast<std::int64_t>(less) >= 0) {
      left = less;
      ++quotient;
    }
  } while (!is_last);
  rest = left;
  return quotient;
}

/// floor(sqrt(n)). Leaves n less the square of that in `n`: at most twice the root.
FIXED_NOINLINE constexpr std::uint32_t take_root(std::uint64_t& n) noexcept {
  std::uint64_t rest = n;
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 62; bit > 0; bit >>= 2) {
    const std::uint64_t trial = root + bit;
    root >>= 1;
    if (rest >= trial) {
      rest -= trial;
      root += bit;
    }
  }
  n = rest;
  return static_cast<std::uint32_t>(root);
}

/// The integer nearest to both ends in units of 2^-bits, or `undecided` if there are two.
FIXED_NOINLINE constexpr std::int64_t nearest_or_undecided(std::int64_t low, std::int64_t high,
                                                           int bits) noexcept {
  const std::int64_t ulps = nearest_within(low, std::int64_t{0}, bits).low;
  return nearest_within(high, std::int64_t{0}, bits).low == ulps ? ulps : undecided;
}

/// The integer nearest to value +- error, likewise.
constexpr std::int64_t nearest_or_undecided_within(std::int64_t value, std::int32_t error,
                                                   int bits) noexcept {
  return nearest_or_undecided(value - error, value + error, bits);
}

/// `ulps`, or what the digits compute if it is undecided; programs in which it never is do not
/// contain digits.
template <bool IsAlways, class Digits>
constexpr std::int64_t decided(std::int64_t ulps, const Digits& digits) noexcept {
  if constexpr (IsAlways) {
    FIXED_ASSERT(ulps != undecided);
    return ulps;
  } else {
    return ulps != undecided ? ulps : digits();
  }
}

}  // namespace fixproof::detail::in_compact_words
