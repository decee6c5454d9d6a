/// @file
/// Numbers with 184 bits after the point in digits of 16 bits, for programs that must be small.
///
/// The arithmetic is that of real.hpp to the bit. Every function shares its loops over one array,
/// and products have 32 bits, because a Cortex-M0 has no others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/function_tables.hpp"

namespace fixproof::detail::in_digits {

using digit = std::uint16_t;
using two_digits = std::uint32_t;
inline constexpr int digit_bits = 16;

inline constexpr int real_bits = 184;
inline constexpr int real_digits = 224 / digit_bits;

constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

/// The lowest digit of short numbers, which have 88 bits after the point: enough for almost every
/// result, in a fraction of the time.
inline constexpr int short_digit = 96 / digit_bits;

/// An integer of 224 bits in two's complement. It counts units of 2^-184, or of 2^-88 if it is
/// short. It is from -2^39 to 2^39; sums, products and shifts are modulo 2^40.
///
/// An operation rounds to the units of the number that it changes. If that is short, and the other
/// is not, the operation ignores the lower bits of the other: below 2^-88 in sums and divisors, and
/// below 2^-96 in factors.
///
/// Functions take it by reference. g++ 12 can leave out the call that computes a number, if who got
/// it by reference only passes a copy on to a function that is not inlined (bug of ipa-modref).
class real {
 public:
  constexpr real() noexcept = default;

  explicit constexpr real(std::int64_t units) noexcept {
    for (digit& place : digits_) {
      place = static_cast<digit>(units);
      units >>= digit_bits;
    }
  }

  explicit constexpr real(const real_words& words) noexcept {
    for (int i = 0; i < real_digits; ++i) {
      const int bit = i * digit_bits;
      if (bit < 192) {
        digits_[index(i)] = static_cast<digit>(words[index(bit / 64)] >> bit % 64);
      }
    }
  }

  [[nodiscard]] constexpr bool negative() const noexcept {
    return digits_[index(real_digits - 1)] >> (digit_bits - 1) != 0;
  }

  [[nodiscard]] constexpr int lowest() const noexcept { return lowest_; }

  /// Makes digit `lowest` the lowest in use. @pre those below it are 0
  constexpr void use_from(int lowest) noexcept { lowest_ = lowest; }

  /// The units of 2^-184 modulo 2^64.
  [[nodiscard]] constexpr std::int64_t units() const noexcept {
    std::uint64_t low = 0;
    for (int i = 64 / digit_bits; i-- > 0;) low = low << digit_bits | digits_[index(i)];
    return static_cast<std::int64_t>(low);
  }

  /// Whether units() is the number itself.
  [[nodiscard]] constexpr bool is_word() const noexcept { return real(units()).digits_ == digits_; }

  /// Adds b, and a unit if `carry` is 1.
  constexpr void add(const real& b, two_digits carry) noexcept {
    for (int i = lowest_; i < real_digits; ++i) {
      carry += two_digits{digits_[index(i)]} + b.digits_[index(i)];
      digits_[index(i)] = static_cast<digit>(carry);
      carry >>= digit_bits;
    }
  }

  constexpr void operator+=(const real& b) noexcept { add(b, 0); }

  constexpr void negate() noexcept {
    for (int i = lowest_; i < real_digits; ++i) {
      digits_[index(i)] = static_cast<digit>(~digits_[index(i)]);
    }
    add(real(), 1);
  }

  constexpr void operator-=(const real& b) noexcept {
    // -(-x + b), which takes less code than a loop
    negate();
    add(b, 0);
    negate();
  }

  /// Multiplies by 2^places and rounds toward -infinity. @pre -224 < places < 224
  constexpr void shift(int places) noexcept {
    const real old = *this;
    const int whole = places >= 0 ? places / digit_bits : -((digit_bits - 1 - places) / digit_bits);
    const int rest = places - whole * digit_bits;
    for (int i = lowest_; i < real_digits; ++i) {
      const two_digits both = two_digits{old.at(i - whole)} << digit_bits | old.at(i - whole - 1);
      digits_[index(i)] = static_cast<digit>(both << rest >> digit_bits);
    }
  }

  /// The product, rounded down. @pre 0 <= b < 2^32
  constexpr void operator*=(const real& b) noexcept {
    // 2^8 b counts units of 2^-192, and 192 bits are whole digits.
    constexpr int whole = 192 / digit_bits;
    real factor = b;
    factor.shift(192 - real_bits);
    std::array<digit, index(whole + 2 * real_digits)> sum{};
    for (int i = lowest_; i < whole + real_digits; ++i) {
      const two_digits each = at(i);
      if (each == 0) continue;
      two_digits carry = 0;
      for (int k = lowest_; k < real_digits; ++k) {
        carry += each * factor.digits_[index(k)] + sum[index(i + k)];
        sum[index(i + k)] = static_cast<digit>(carry);
        carry >>= digit_bits;
      }
      sum[index(i + real_digits)] = static_cast<digit>(carry);
    }
    for (int i = lowest_; i < real_digits; ++i) digits_[index(i)] = sum[index(i + whole)];
  }

  /// The quotient, rounded down. @pre *this >= 0, n > 0
  constexpr void operator/=(digit n) noexcept {
    two_digits rest = 0;
    for (int i = real_digits; i-- > lowest_;) {
      rest = rest << digit_bits | digits_[index(i)];
      digits_[index(i)] = static_cast<digit>(rest / n);
      rest %= n;
    }
  }

  /// The quotient, rounded down. @pre *this >= 0, 0 < b < 2^38, the quotient is below 2^39
  constexpr void operator/=(const real& b) noexcept {
    // One bit at a time. Those of the quotient take the places of those of the dividend.
    real minus = b;
    minus.use_from(lowest_);
    minus.negate();
    real rest;
    rest.use_from(lowest_);
    const int steps = real_digits * digit_bits + real_bits - 2 * lowest_ * digit_bits;
    for (int i = 0; i < steps; ++i) {
      rest.add(rest, negative() ? 1 : 0);
      rest += minus;
      const bool fits = !rest.negative();
      if (!fits) rest += b;
      add(*this, fits ? 1 : 0);
    }
  }

 private:
  /// Digit i, also beyond both ends.
  [[nodiscard]] constexpr digit at(int i) const noexcept {
    if (i < 0) return 0;
    if (i < real_digits) return digits_[index(i)];
    return negative() ? static_cast<digit>(-1) : digit{0};
  }

  std::array<digit, index(real_digits)> digits_{};
  int lowest_ = 0;
};

}  // namespace fixproof::detail::in_digits
