/// @file
/// Floating-point types besides float and double: long double, the types of 16 bits, and those of
/// C++23. Decodes the wide ones with integers, as fixed/detail/floating.hpp does.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/bit_cast.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/wide_integer.hpp"

// g++ 12 has _Float16 in C++ on x86 alone, but its macro everywhere.
#if defined(__FLT16_MANT_DIG__) && \
    (defined(__clang__) || __GNUC__ >= 13 || (__GNUC__ == 12 && defined(__SSE2__)))
#define FIXED_HAS_FLOAT16
#endif

namespace fixproof::detail {

/// Types of 16 bits that the compiler has, but that std::is_floating_point may not know.
template <class Type>
inline constexpr bool is_half_float = false;
#if defined(FIXED_HAS_FLOAT16)
__extension__ using half_float = _Float16;
template <>
inline constexpr bool is_half_float<half_float> = true;
#endif
#if defined(__ARM_FP16_FORMAT_IEEE)
template <>
inline constexpr bool is_half_float<__fp16> = true;
#endif

/// A type whose values are all doubles.
template <class Type>
concept narrow_float = is_half_float<std::remove_cv_t<Type>> ||
    (std::is_floating_point_v<Type> && !binary_float<Type> &&
     std::numeric_limits<Type>::digits <= 53 && std::numeric_limits<Type>::max_exponent <= 1024);

/// The significand and the exponent of a wider type, as they are stored.
struct stored_float {
  bool negative;
  int exponent;             ///< with its bias, which is 16383
  std::uint64_t high, low;  ///< the significand, its leading digit included
};

/// Whether the type is that of the x87, or binary128 of IEEE 754.
template <class Type>
concept wide_float = std::is_floating_point_v<Type> &&
                         std::numeric_limits<Type>::max_exponent == 16384 &&
                     (std::numeric_limits<Type>::digits == 113
#if defined(__x86_64__) || defined(__i386__)
                      || std::numeric_limits<Type>::digits == 64
#endif
                     );

/// Any type that number converts from, besides float and double.
template <class Type>
concept other_float = narrow_float<Type> || wide_float<Type>;

/// The parts of a value.
template <wide_float Float>
constexpr stored_float parts_of(Float x) noexcept {
  constexpr std::uint64_t leading = std::uint64_t{1} << 63;
  if constexpr (std::numeric_limits<Float>::digits == 64) {
    struct layout {
      std::uint64_t significand;
      std::uint16_t sign_and_exponent;
      unsigned char padding[sizeof(Float) - 10];  // NOLINT(*-avoid-c-arrays): as it is stored
    };
    const auto bits = bit_cast<layout>(x);
    const int exponent = bits.sign_and_exponent & 0x7fff;
    // A leading 0 makes no number unless the exponent is 0. To the processor, it is as NaN.
    const bool is_number = exponent == 0 || (bits.significand & leading) != 0;
    return {bits.sign_and_exponent >> 15 != 0, is_number ? exponent : 0x7fff,
            is_number ? bits.significand & (exponent == 0x7fff ? ~leading : ~std::uint64_t{0}) : 1,
            0};
  } else {
    struct layout {
      std::uint64_t words[2];  // NOLINT(*-avoid-c-arrays): as it is stored
    };
    const auto bits = bit_cast<layout>(x);
    constexpr int top = std::endian::native == std::endian::little ? 1 : 0;
    const int exponent = static_cast<int>(bits.words[top] >> 48) & 0x7fff;
    const std::uint64_t rest = bits.words[top] & ((std::uint64_t{1} << 48) - 1);
    const bool has_leading = exponent != 0 && exponent != 0x7fff;
    return {bits.words[top] >> 63 != 0, exponent, rest | std::uint64_t{has_leading} << 48,
            bits.words[1 - top]};
  }
}

/// As the function of the same name in fixed/detail/floating.hpp.
template <rounding Rounding, class Wide, wide_float Float>
constexpr scaled_float<Wide> scale(Float x, int scale) noexcept {
  static_assert(std::same_as<Wide, wide_integer<3>>);
  using kind = typename scaled_float<Wide>::kind;
  constexpr bool has_low = std::numeric_limits<Float>::digits == 113;
  const stored_float parts = parts_of(x);
  if (parts.exponent == 0x7fff) {
    const bool is_infinite = (parts.high | parts.low) == 0;
    return {is_infinite ? kind::infinite : kind::nan, parts.negative, Wide{0}};
  }
  const Wide magnitude = has_low ? (Wide{parts.high} << 64) + Wide{parts.low} : Wide{parts.high};
  const Wide value = parts.negative ? -magnitude : magnitude;
  const int exponent = (parts.exponent == 0 ? 1 : parts.exponent) - 16383 -
                       (std::numeric_limits<Float>::digits - 1) + scale;
  // The significand has at most 113 bits, so a shift beyond 120 equals a shift by 120. Shifted to
  // the left by 64 it has 178, with the sign; from 2^65 units on it exceeds every Raw.
  if (exponent < 0) {
    return {kind::finite, parts.negative,
            shift_right<Rounding>(value, exponent < -120 ? 120 : -exponent)};
  }
  if (exponent <= 64) return {kind::finite, parts.negative, value << exponent};
  return {kind::beyond, parts.negative, Wide{0}};
}

}  // namespace fixproof::detail
