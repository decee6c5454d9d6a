/// @file
/// Integers of up to 18 digits of 32 bits, for intervals.
///
/// Products have 64 bits, so every compiler and processor takes the same steps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/bits.hpp"

namespace fixproof::detail {

/// An integer of `size` digits that is not negative; the last digit comes first.
struct limb_integer {
  static constexpr std::size_t most = 18;

  std::size_t size;
  std::array<std::uint32_t, most> digits{};

  [[nodiscard]] constexpr bool has_first_bit() const noexcept {
    return digits[size - 1] >> 31 != 0;
  }

  /// The first 64 bits.
  [[nodiscard]] constexpr std::uint64_t top() const noexcept {
    return std::uint64_t{digits[size - 1]} << 32 | digits[size - 2];
  }

  /// The number of digits before the first that is not 0.
  [[nodiscard]] constexpr std::size_t zero_digits() const noexcept {
    std::size_t zeros = 0;
    while (zeros < size && digits[size - 1 - zeros] == 0) ++zeros;
    return zeros;
  }

  /// The number of bits before the first that is not 0.
  [[nodiscard]] constexpr int zero_bits() const noexcept {
    const std::size_t zeros = zero_digits();
    const int bits = 32 * static_cast<int>(zeros);
    return zeros < size ? bits + leading_zeros(digits[size - 1 - zeros]) : bits;
  }

  /// Drops the last digits. Returns whether one of them is not 0. @pre count < size
  constexpr bool drop_last(std::size_t count) noexcept {
    std::uint32_t dropped = 0;
    for (std::size_t i = 0; i < count; ++i) dropped |= digits[i];
    size -= count;
    for (std::size_t i = 0; i < size; ++i) digits[i] = digits[i + count];
    return dropped != 0;
  }

  /// Appends digits that are 0. @pre size + count <= most
  constexpr void append_zeros(std::size_t count) noexcept {
    size += count;
    for (std::size_t i = size; i-- > count;) digits[i] = digits[i - count];
    for (std::size_t i = 0; i < count; ++i) digits[i] = 0;
  }

  /// @pre 0 < places < 32 size
  constexpr void shift_left(int places) noexcept {
    const auto whole = static_cast<std::size_t>(places) / 32;
    const int rest = places % 32;
    for (std::size_t i = size; i-- > 0;) {
      const std::uint64_t upper = i >= whole ? digits[i - whole] : 0;
      const std::uint64_t lower = i >= whole + 1 ? digits[i - whole - 1] : 0;
      digits[i] = static_cast<std::uint32_t>((upper << 32 | lower) << rest >> 32);
    }
  }

  /// Drops the last bits. Returns whether one of them is not 0. @pre places > 0
  constexpr bool shift_right(int places) noexcept {
    const auto whole = static_cast<std::size_t>(places) / 32;
    const int rest = places % 32;
    const auto at = [&](std::size_t i) { return i < size ? std::uint64_t{digits[i]} : 0; };
    std::uint64_t dropped = at(whole) << (32 - rest) & 0xffffffff;
    for (std::size_t i = 0; i < whole && i < size; ++i) dropped |= digits[i];
    for (std::size_t i = 0; i < size; ++i) {
      digits[i] = static_cast<std::uint32_t>((at(i + whole + 1) << 32 | at(i + whole)) >> rest);
    }
    return dropped != 0;
  }

  /// 2^(32 size) less the integer.
  constexpr void negate() noexcept {
    std::uint64_t carry = 1;
    for (std::size_t i = 0; i < size; ++i) {
      carry += ~digits[i];
      digits[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
  }

  /// Adds an integer of as many digits, or subtracts it. Returns the carry, -1, 0 or 1.
  constexpr int add(const limb_integer& other, bool is_sum) noexcept {
    std::int64_t carry = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::int64_t digit = other.digits[i];
      carry += std::int64_t{digits[i]} + (is_sum ? digit : -digit);
      digits[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    return static_cast<int>(carry);
  }

  /// a b / 2^(32 n) for two integers of n digits, rounded down, or less by 1.
  ///
  /// The columns of the product before the last two of its lower half are not summed. These are at
  /// most n 2^(32 (n - 1)), less than a unit of the result.
  [[nodiscard]] friend constexpr limb_integer upper_product(const limb_integer& a,
                                                            const limb_integer& b) noexcept {
    const std::size_t n = a.size;
    std::array<std::uint32_t, 2 * most> product{};
    for (std::size_t i = 0; i < n; ++i) {
      std::uint64_t carry = 0;
      const std::size_t first = i + 2 < n ? n - 2 - i : 0;
      const std::uint64_t digit = a.digits[i];
      for (std::size_t k = first; k < n; ++k) {
        carry += digit * b.digits[k] + product[i + k];
        product[i + k] = static_cast<std::uint32_t>(carry);
        carry >>= 32;
      }
      product[i + n] = static_cast<std::uint32_t>(carry);
    }
    limb_integer result{n};
    for (std::size_t i = 0; i < n; ++i) result.digits[i] = product[n + i];
    return result;
  }

  /// Divides by n, rounded down. Returns the remainder. @pre n > 0
  constexpr std::uint32_t divide(std::uint32_t n) noexcept {
    std::uint64_t rest = 0;
    for (std::size_t i = size; i-- > 0;) {
      rest = rest << 32 | digits[i];
      digits[i] = static_cast<std::uint32_t>(rest / n);
      rest %= n;
    }
    return static_cast<std::uint32_t>(rest);
  }

  /// a 2^(32 n - 1) / b for two integers of n digits, rounded down, by Knuth's algorithm D.
  /// @pre the first bit of b is 1
  [[nodiscard]] friend constexpr limb_integer upper_quotient(const limb_integer& a,
                                                             const limb_integer& b) noexcept {
    const std::size_t n = a.size;
    limb_integer result{n};
    std::array<std::uint32_t, 2 * most + 1> rest{};
    for (std::size_t i = 0; i <= n; ++i) {
      const std::uint64_t upper = i < n ? a.digits[i] : 0;
      const std::uint64_t lower = i > 0 ? a.digits[i - 1] : 0;
      rest[n - 1 + i] = static_cast<std::uint32_t>((upper << 32 | lower) >> 1);
    }
    const std::uint64_t first = b.digits[n - 1];
    const std::uint64_t second = b.digits[n - 2];
    for (std::size_t k = n; k-- > 0;) {
      const std::uint64_t top = std::uint64_t{rest[k + n]} << 32 | rest[k + n - 1];
      std::uint64_t digit = top / first;
      std::uint64_t over = top % first;
      while (digit >> 32 != 0 || digit * second > (over << 32 | rest[k + n - 2])) {
        --digit;
        over += first;
        if (over >> 32 != 0) break;
      }
      std::uint64_t carry = 0;
      std::int64_t borrow = 0;
      for (std::size_t i = 0; i < n; ++i) {
        carry += digit * b.digits[i];
        borrow += std::int64_t{rest[k + i]} - static_cast<std::int64_t>(carry & 0xffffffff);
        rest[k + i] = static_cast<std::uint32_t>(borrow);
        carry >>= 32;
        borrow >>= 32;
      }
      borrow += std::int64_t{rest[k + n]} - static_cast<std::int64_t>(carry);
      rest[k + n] = static_cast<std::uint32_t>(borrow);
      if (borrow < 0) {
        --digit;
        carry = 0;
        for (std::size_t i = 0; i < n; ++i) {
          carry += std::uint64_t{rest[k + i]} + b.digits[i];
          rest[k + i] = static_cast<std::uint32_t>(carry);
          carry >>= 32;
        }
        rest[k + n] = 0;
      }
      result.digits[k] = static_cast<std::uint32_t>(digit);
    }
    return result;
  }
};

}  // namespace fixproof::detail
