/// @file
/// Signed integers of any width, for exact results before they are rounded.
#pragma once

#include <array>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "fixed/detail/gpu.hpp"

namespace fixproof::detail {

/// 128 bits: the compiler's integer if it has one and FIXED_NO_INT128 is not defined.
#if defined(__SIZEOF_INT128__) && !defined(FIXED_NO_INT128)
__extension__ using int128 = __int128;
#else
template <std::size_t Words>
class wide_integer;
using int128 = wide_integer<2>;
#endif

// Freestanding libraries may lack <algorithm>.
constexpr int larger(int a, int b) noexcept { return a < b ? b : a; }
constexpr int largest(int a, int b, int c) noexcept { return larger(a, larger(b, c)); }

/// The order of two values, from whether the first is less or greater. nvcc does not put the
/// objects of std::strong_ordering into the memory of a GPU; without them, g++ takes half as long
/// again.
constexpr std::strong_ordering ordering(bool less, bool greater) noexcept {
#if defined(FIXED_GPU) && defined(__NVCC__)
  return int{greater} <=> int{less};
#else
  return less      ? std::strong_ordering::less
         : greater ? std::strong_ordering::greater
                   : std::strong_ordering::equal;
#endif
}

/// The product of two words.
struct two_words {
  std::uint64_t low;
  std::uint64_t high;
};

constexpr two_words multiply_words(std::uint64_t a, std::uint64_t b) noexcept {
#if defined(__SIZEOF_INT128__) && !defined(FIXED_NO_INT128)
  __extension__ using wide = unsigned __int128;
  const wide product = static_cast<wide>(a) * b;
  return {static_cast<std::uint64_t>(product), static_cast<std::uint64_t>(product >> 64)};
#else
  constexpr std::uint64_t low_half = 0xffffffff;
  const std::uint64_t a0 = a & low_half;
  const std::uint64_t a1 = a >> 32;
  const std::uint64_t b0 = b & low_half;
  const std::uint64_t b1 = b >> 32;
  const std::uint64_t middle = a1 * b0 + (a0 * b0 >> 32);
  const std::uint64_t carry = ((middle & low_half) + a0 * b1) >> 32;
  return {a * b, a1 * b1 + (middle >> 32) + carry};
#endif
}

/// floor(a * b / 2^64).
constexpr std::uint64_t multiply_high(std::uint64_t a, std::uint64_t b) noexcept {
  return multiply_words(a, b).high;
}

/// A two's complement integer of 64 Words bits. Sums, products and left shifts are modulo its
/// range.
template <std::size_t Words>
class wide_integer {
 public:
  constexpr wide_integer() noexcept = default;

  /// Any integer of at most 64 bits. Implicit, as between built-in integers.
  template <std::integral Int>
  requires(sizeof(Int) <= sizeof(std::uint64_t))  // NOLINTNEXTLINE(google-explicit-constructor)
      constexpr wide_integer(Int value) noexcept {
    words_[0] = static_cast<std::uint64_t>(value);
    if constexpr (std::is_signed_v<Int>) {
      for (std::size_t i = 1; i < Words; ++i) words_[i] = value < 0 ? ~std::uint64_t{0} : 0;
    }
  }

  template <std::size_t Fewer>
  requires(Fewer <
           Words) explicit constexpr wide_integer(const wide_integer<Fewer>& value) noexcept {
    for (std::size_t i = 0; i < Words; ++i) words_[i] = value.word(i);
  }

#if defined(__SIZEOF_INT128__) && !defined(FIXED_NO_INT128)
  explicit constexpr wide_integer(int128 value) noexcept {
    words_[0] = static_cast<std::uint64_t>(value);
    for (std::size_t i = 1; i < Words; ++i) {
      words_[i] = static_cast<std::uint64_t>(value >> (i == 1 ? 64 : 127));
    }
  }
#endif

  /// Bits 64 i to 64 i + 63 of the integer, also beyond its range.
  [[nodiscard]] constexpr std::uint64_t word(std::size_t i) const noexcept {
    return i < Words ? words_[i] : negative() ? ~std::uint64_t{0} : std::uint64_t{0};
  }

  /// The integer modulo 2^bits of Int.
  template <std::integral Int>
  explicit constexpr operator Int() const noexcept {
    return static_cast<Int>(words_[0]);
  }

  [[nodiscard]] constexpr bool negative() const noexcept { return words_[Words - 1] >> 63 != 0; }

  constexpr wide_integer operator-() const noexcept { return wide_integer() - *this; }

  constexpr wide_integer& operator+=(const wide_integer& b) noexcept {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < Words; ++i) {
      const std::uint64_t sum = words_[i] + carry;
      carry = sum < carry ? 1U : 0U;
      words_[i] = sum + b.words_[i];
      carry += words_[i] < sum ? 1U : 0U;
    }
    return *this;
  }
  constexpr wide_integer& operator-=(const wide_integer& b) noexcept {
    std::uint64_t borrow = 0;
    for (std::size_t i = 0; i < Words; ++i) {
      const std::uint64_t difference = words_[i] - b.words_[i];
      const std::uint64_t lost = words_[i] < b.words_[i] ? 1U : 0U;
      words_[i] = difference - borrow;
      borrow = lost + (difference < borrow ? 1U : 0U);
    }
    return *this;
  }

  /// The same for one word, in a third of the instructions of a processor of 32 bits.
  constexpr wide_integer& operator+=(std::int64_t b) noexcept requires(Words == 2) {
    const auto low = static_cast<std::uint64_t>(b);
    words_[0] += low;
    words_[1] += static_cast<std::uint64_t>(b >> 63) + (words_[0] < low ? 1U : 0U);
    return *this;
  }
  constexpr wide_integer& operator-=(std::int64_t b) noexcept requires(Words == 2) {
    const auto low = static_cast<std::uint64_t>(b);
    words_[1] -= static_cast<std::uint64_t>(b >> 63) + (words_[0] < low ? 1U : 0U);
    words_[0] -= low;
    return *this;
  }

  friend constexpr wide_integer operator+(wide_integer a, const wide_integer& b) noexcept {
    return a += b;
  }
  friend constexpr wide_integer operator-(wide_integer a, const wide_integer& b) noexcept {
    return a -= b;
  }

  friend constexpr wide_integer operator*(const wide_integer& a, const wide_integer& b) noexcept {
    wide_integer result;
    for (std::size_t i = 0; i < Words; ++i) {
      std::uint64_t carry = 0;
      for (std::size_t k = 0; i + k < Words; ++k) {
        two_words product = multiply_words(a.words_[i], b.words_[k]);
        product.low += carry;
        product.high += product.low < carry ? 1U : 0U;
        std::uint64_t& word = result.words_[i + k];
        word += product.low;
        carry = product.high + (word < product.low ? 1U : 0U);
      }
    }
    return result;
  }

  /// The remainder with the sign of a. @pre b is not zero; both have a bit to spare
  friend constexpr wide_integer operator%(const wide_integer& a, const wide_integer& b) noexcept {
    const wide_integer rest = divide(a.negative() ? -a : a, b.negative() ? -b : b).remainder;
    return a.negative() ? -rest : rest;
  }

  /// @pre 0 <= bits < 64 Words
  friend constexpr wide_integer operator<<(const wide_integer& x, int bits) noexcept {
    wide_integer result;
    const auto skipped = static_cast<std::size_t>(bits) / 64;
    const int rest = bits % 64;
    for (std::size_t i = skipped; i < Words; ++i) {
      result.words_[i] = x.words_[i - skipped] << rest;
      if (rest != 0 && i > skipped) {
        result.words_[i] |= x.words_[i - skipped - 1] >> (64 - rest);
      }
    }
    return result;
  }

  /// Rounds toward -infinity. @pre 0 <= bits < 64 Words
  friend constexpr wide_integer operator>>(const wide_integer& x, int bits) noexcept {
    wide_integer result;
    const auto skipped = static_cast<std::size_t>(bits) / 64;
    const int rest = bits % 64;
    for (std::size_t i = 0; i < Words; ++i) {
      result.words_[i] = x.word(i + skipped) >> rest;
      if (rest != 0) result.words_[i] |= x.word(i + skipped + 1) << (64 - rest);
    }
    return result;
  }

  // Not the array's, because clang++ calls memcmp for it, which a GPU does not have.
  friend constexpr bool operator==(const wide_integer& a, const wide_integer& b) noexcept {
    std::uint64_t differing = 0;
    for (std::size_t i = 0; i < Words; ++i) differing |= a.words_[i] ^ b.words_[i];
    return differing == 0;
  }

  friend constexpr std::strong_ordering operator<=>(const wide_integer& a,
                                                    const wide_integer& b) noexcept {
    if (a.negative() != b.negative()) return b.negative() <=> a.negative();
    for (std::size_t i = Words; i-- > 0;) {
      if (a.words_[i] != b.words_[i]) return a.words_[i] <=> b.words_[i];
    }
    return ordering(false, false);
  }

  /// The quotient and the remainder of magnitudes. @pre x >= 0, divisor > 0, one bit to spare
  struct division;
  static constexpr division divide(const wide_integer& x, const wide_integer& divisor) noexcept;

 private:
  std::array<std::uint64_t, Words> words_{};
};

template <std::size_t Words>
struct wide_integer<Words>::division {
  wide_integer quotient{};
  wide_integer remainder{};
};

// One bit at a time: only formats of 64 bits come here, a few of 32 without 128-bit integers, and %
// of a number of 32 bits and an integer.
template <std::size_t Words>
constexpr auto wide_integer<Words>::divide(const wide_integer& x,
                                           const wide_integer& divisor) noexcept -> division {
  division result;
  for (std::size_t i = Words; i-- > 0;) {
    for (int bit = 63; bit >= 0; --bit) {
      result.remainder = result.remainder << 1;
      result.remainder.words_[0] |= x.words_[i] >> bit & 1;
      if (result.remainder < divisor) continue;
      result.remainder = result.remainder - divisor;
      result.quotient.words_[i] |= std::uint64_t{1} << bit;
    }
  }
  return result;
}

/// The fastest signed integer with at least that many bits: 32 or 64, 128 from the compiler if it
/// has it, else a wide_integer.
template <int Bits>
using signed_t = std::conditional_t<
    (Bits <= 32), std::int32_t,
    std::conditional_t<
        (Bits <= 64), std::int64_t,
        std::conditional_t<(Bits <= 128), int128,
                           wide_integer<static_cast<std::size_t>((Bits + 63) / 64)>>>>;

template <class Int>
inline constexpr bool is_built_in = true;
template <std::size_t Words>
inline constexpr bool is_built_in<wide_integer<Words>> = false;

}  // namespace fixproof::detail
