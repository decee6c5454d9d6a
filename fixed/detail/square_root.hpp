/// @file
/// The integer nearest to a square root, and bounds of the root.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/hardware.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The integer nearest to sqrt(x 2^(2 Bits)), in words of 32 bits, for Bits <= 12.
///
/// One bit of the root at a time. First floor(sqrt(x)): before each step, x holds what the root so
/// far leaves of it, and root that root times 2^(bits to come + 1). Then Bits more bits: rest is
/// x 2^(2 bits so far) - root^2 <= 2 root < 2^(17 + Bits), so 4 rest has at most 31 bits.
///
/// There are no ties: (r + 1/2)^2 = r^2 + r + 1/4 is not an integer. So the nearest is r =
/// floor(sqrt(n)) if n - r^2 <= r, and r + 1 otherwise.
template <int Bits>
constexpr std::uint32_t nearest_sqrt_in_words(std::uint32_t x) noexcept {
  static_assert(Bits <= 12);
  std::uint32_t root = 0;
  for (std::uint32_t bit = std::uint32_t{1} << 30; bit != 0; bit >>= 2) {
    const std::uint32_t trial = root + bit;
    root >>= 1;
    if (x >= trial) {
      x -= trial;
      root += bit;
    }
  }
  std::uint32_t rest = x;
  for (int bit = 0; bit < Bits; ++bit) {
    rest <<= 2;
    const std::uint32_t trial = root << 2 | 1;
    root <<= 1;
    if (rest >= trial) {
      rest -= trial;
      ++root;
    }
  }
  return root + (rest > root ? 1 : 0);
}

/// The integer nearest to sqrt(n), for 0 <= n < 2^(2 Pairs).
///
/// Takes two bits of n at a time from the top: after each step, rest = n - root^2 for the bits so
/// far, so 0 <= rest <= 2 root.
template <int Pairs, class Wide>
constexpr Wide nearest_sqrt_by_pairs(const Wide& n) noexcept {
  Wide root{0};
  Wide rest{0};
  for (int pair = Pairs - 1; pair >= 0; --pair) {
    const Wide bits = n >> (2 * pair);
    rest = (rest << 2) + (bits - (bits >> 2 << 2));
    const Wide trial = (root << 2) + Wide{1};
    root = root << 1;
    if (!(rest < trial)) {
      rest = rest - trial;
      root = root + Wide{1};
    }
  }
  return root < rest ? root + Wide{1} : root;
}

/// The integer nearest to sqrt(n). The root of a double is off by less than 1, because the double
/// is off by at most 2^-52 n in every rounding mode.
constexpr std::int64_t nearest_sqrt_of_word(std::uint64_t n) noexcept {
  if constexpr (hardware_double) {
    if (!std::is_constant_evaluated()) {
      constexpr std::uint64_t highest = 0xFFFFFFFF;
      auto root = static_cast<std::uint64_t>(sqrt(static_cast<double>(n)));
      if (root > highest) root = highest;
      if (root * root > n) --root;
      std::uint64_t rest = n - root * root;
      if (rest > 2 * root) {
        rest -= 2 * root + 1;
        ++root;
      }
      return static_cast<std::int64_t>(root + (rest > root ? 1 : 0));
    }
  }
  return static_cast<std::int64_t>(nearest_sqrt_by_pairs<32>(n));
}

/// sqrt(n) by rule Rounding, from the integer nearest to it.
template <rounding Rounding, class Wide>
constexpr Wide rounded_root(const Wide& nearest, const Wide& n) noexcept {
  if constexpr (is_to_nearest<Rounding>) {
    return nearest;
  } else {
    const Wide square = nearest * nearest;
    const bool is_up = Rounding == rounding::ceiling;
    return nearest + Wide{is_up && square < n} - Wide{!is_up && n < square};
  }
}

/// sqrt(n) by rule Rounding.
template <rounding Rounding>
constexpr auto rounded_sqrt_of_word(std::uint64_t n) noexcept {
  const std::int64_t nearest = nearest_sqrt_of_word(n);
  if constexpr (is_to_nearest<Rounding>) {
    return nearest;
  } else {
    // The square of the nearest integer can be 2^64.
    return rounded_root<Rounding>(int128{nearest}, int128{n});
  }
}

/// Whether nearest_root() takes a hardware root without a correction.
template <class Raw, int FractionBits>
inline constexpr bool has_fast_root = std::numeric_limits<Raw>::digits + FractionBits < 48 &&
                                      FractionBits <= std::numeric_limits<Raw>::digits;

/// Whether no root is out of range. Otherwise 1/2 is out of range, and so are the roots of 1/4 and
/// more.
template <class Raw, int FractionBits>
inline constexpr bool has_every_root = FractionBits <= std::numeric_limits<Raw>::digits;

/// The stored integer nearest to the root of a stored integer.
///
/// The hardware root of n = raw 2^FractionBits < 2^47 is below 2^23.5, so it is off by less than
/// 2^-29 in every rounding mode, and adding a half by as much again: 2^-28 together. Every root is
/// more than 1 / (8 r + 4) > 2^-27 away from a half r + 1/2 (see nearest_sqrt_in_words()), so
/// truncating the sum gives the nearest integer. Compilers vectorise this, unless sqrt sets errno.
/// @pre raw >= 0
template <int FractionBits, class Raw>
constexpr auto nearest_root(Raw raw) noexcept {
  if constexpr (has_fast_root<Raw, FractionBits>) {
    if constexpr (hardware_double) {
      if (!std::is_constant_evaluated()) {
#if defined(__FMA__) || defined(__aarch64__)
        // Compilers fuse a product with the sum, so most of the scaling follows the root.
        constexpr int later = FractionBits / 2;
#else
        constexpr int later = 0;
#endif
        constexpr double before = std::int64_t{1} << (FractionBits - 2 * later);
        constexpr double after = std::int64_t{1} << later;
        // NOLINTNEXTLINE(bugprone-incorrect-roundings): right, as proven above
        return std::int64_t{static_cast<std::int32_t>(sqrt(raw * before) * after + 0.5)};
      }
    }
    constexpr int odd = FractionBits % 2;
    if constexpr (std::numeric_limits<Raw>::digits + odd <= 32) {
      const auto x = static_cast<std::uint32_t>(raw) << odd;
      return std::int64_t{nearest_sqrt_in_words<FractionBits / 2>(x)};
    } else {
      return nearest_sqrt_of_word(static_cast<std::uint64_t>(raw) << FractionBits);
    }
  } else if constexpr (sizeof(Raw) < sizeof(std::int64_t)) {
    return nearest_sqrt_of_word(static_cast<std::uint64_t>(raw) << FractionBits);
  } else {
    constexpr int bits = std::numeric_limits<Raw>::digits + FractionBits;
    using wide = signed_t<bits + 3>;
    return nearest_sqrt_by_pairs<(bits + 1) / 2>(wide{raw} << FractionBits);
  }
}

/// The stored integer of the root of a stored integer, by rule Rounding. @pre raw >= 0
template <rounding Rounding, int FractionBits, class Raw>
constexpr auto stored_root(Raw raw) noexcept {
  const auto nearest = nearest_root<FractionBits>(raw);
  if constexpr (is_to_nearest<Rounding>) {
    return nearest;
  } else {
    using wide = signed_t<larger(65, std::numeric_limits<Raw>::digits + FractionBits + 3)>;
    return rounded_root<Rounding>(wide{nearest}, wide{raw} << FractionBits);
  }
}

}  // namespace fixproof::detail
