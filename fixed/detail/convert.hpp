/// @file
/// Converts floats and doubles to stored integers of at most 32 bits, with integers, in code that
/// compilers vectorise. Bit-identical to detail::scale() and detail::narrow().
///
/// Constant expressions use it, too. If the constructor had std::is_constant_evaluated(), g++ 12
/// would initialise global numbers only when the program starts.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/bit_cast.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// Whether converted() supports the conversion.
template <class Raw, overflow Overflow>
inline constexpr bool has_fast_conversion = bits_of<Raw> <= 32 && Overflow != overflow::trap;

/// Returns `yes` if the condition holds, else `no`. g++ vectorises masks better than conditions.
constexpr std::uint64_t select(bool condition, std::uint64_t yes, std::uint64_t no) noexcept {
  const std::uint64_t mask = 0 - static_cast<std::uint64_t>(condition);
  return (yes & mask) | (no & ~mask);
}

/// Returns `value` / 2^places rounded by rule Rounding, for |value| < 2^53 and places > 0.
template <rounding Rounding>
constexpr std::int64_t shifted(std::int64_t value, std::uint64_t places) noexcept {
  if constexpr (Rounding == rounding::half_up) {
    // Half of the number of halves takes less than to shift a half, too, as shift_right() does.
    const std::uint64_t before = places - 1;
    return ((value >> (before < 63 ? before : 63)) + 1) >> 1;
  } else {
    return shift_right<Rounding>(value, static_cast<int>(places < 60 ? places : 60));
  }
}

/// Returns a float or double as a stored integer, rounded by rule Rounding. See the constructor of
/// number for values out of range, infinities and NaN.
///
/// Every number is an integer times a power of two, so the integer is shifted. Rounding modes,
/// flags and flushed subnormals have no effect on integers. And a single number waits less for a
/// shift than for a double that is rounded.
template <rounding Rounding, overflow Overflow, class Raw, int FractionBits, binary_float Float>
constexpr Raw converted(Float x) noexcept {
  using limits = std::numeric_limits<Float>;
  using word = std::conditional_t<sizeof(Float) == 4, std::uint32_t, std::uint64_t>;
  constexpr int digits = limits::digits - 1;
  constexpr std::uint64_t leading = std::uint64_t{1} << digits;
  constexpr std::uint64_t infinity = (2 * limits::max_exponent - 1) * leading;
  // Biased exponents of one ulp, of doubles whose last digit is one ulp, and out of range.
  constexpr int ulp = limits::max_exponent - 1 - FractionBits;
  constexpr std::uint64_t integers = ulp + 52;
  constexpr std::uint64_t beyond = ulp + std::numeric_limits<Raw>::digits;
  constexpr std::int64_t highest = (std::numeric_limits<Raw>::max)();

  const auto bits = std::uint64_t{bit_cast<word>(x)};
  const std::uint64_t sign = 0 - (bits >> (8 * sizeof(Float) - 1));
  const std::uint64_t magnitude = bits & (infinity + leading - 1);
  const std::uint64_t exponent = magnitude >> digits;
  // As of a double. Zero and subnormal numbers get the leading digit, too: they are far below a
  // half.
  const std::uint64_t significand = ((bits & (leading - 1)) | leading) << (52 - digits);
  auto value = static_cast<std::int64_t>((significand ^ sign) - sign);
  if constexpr (Rounding == rounding::floor || Rounding == rounding::ceiling) {
    value = magnitude == 0 ? 0 : value;
  }
  const std::uint64_t end = static_cast<std::uint64_t>(highest) - sign;

  // One result of all branches, which g++ vectorises better than returns.
  std::uint64_t result = 0;
  if constexpr (Overflow == overflow::saturate) {
    if (exponent >= beyond) [[unlikely]] {
      result = select(magnitude > infinity, 0, end);
    } else {
      if constexpr (!std::is_signed_v<Raw>) value = value < 0 ? 0 : value;
      const std::int64_t rounded = shifted<Rounding>(value, integers - exponent);
      // Of values: g++ finds no minimum of a constant with a name.
      result = static_cast<std::uint64_t>(rounded < std::int64_t{highest} ? rounded
                                                                          : std::int64_t{highest});
    }
  } else {
    result = static_cast<std::uint64_t>(shifted<Rounding>(value, integers - exponent));
    if (exponent >= integers) [[unlikely]] {
      // Shifted by 63, no number has digits in the range.
      const std::uint64_t places = exponent - integers;
      const auto low = static_cast<std::uint64_t>(value) << (places < 63 ? places : 63);
      result = select(magnitude == infinity, end, low);
    }
  }
  return static_cast<Raw>(result);
}

}  // namespace fixproof::detail
