/// \file
/// The rounded quotient of two stored integers: exact, by integers or by hardware doubles.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/hardware.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixed::detail {

/// numerator * 2^Shift / divisor rounded by rule R, in integers. `divisor` is not zero, Shift
/// <= 16.
template <rounding R, int Shift>
constexpr std::int64_t quotient_by_integers(std::int32_t numerator, std::int32_t divisor) noexcept {
  // Both doubled, so that the divisor is even as bias() asks: at most 2^48 and 2^32.
  const std::int64_t scaled = std::int64_t{numerator} * (std::int64_t{2} << Shift);
  const std::int64_t parts = divisor < 0 ? -scaled : scaled;
  const std::int64_t unit = 2 * (divisor < 0 ? -std::int64_t{divisor} : std::int64_t{divisor});
  return floor_divide(parts + bias<R>(parts < 0, unit), unit);
}

/// The same by one division in double, with the result brought into [Lowest, Highest].
///
/// Bit-identical to the integers for every operand and in every rounding mode of the processor:
///
/// Let Q = N / D be the exact quotient, N = numerator * 2^Shift, |N| <= 2^47, 0 < |D| <= 2^31, and
/// q the double nearest to it in the direction of the current mode: |q - Q| < |Q| 2^-52 = |N / D|
/// 2^-52
/// <= 2^-5 / |D|.
///  - If Q is an integer or an integer and a half, it has at most 48 bits, so q = Q, and q +- 1/2
///  is
///    exact.
///  - If not, Q is at least 1 / |D| from every integer and 1 / (2 |D|) from every half. Adding 1/2
///    rounds once more, by less than (|Q| + 1/2) 2^-52 <= 2^-5 / |D| + 2^-53. Both errors together
///    are less than 2^-4 / |D| + 2^-53 < 1 / (2 |D|): no integer lies between Q + 1/2 and what is
///    computed for it, nor is one met. Without the addition the first error alone is less than
///    1 / |D|.
/// So floor and trunc of the sum are those of the exact sum.
///
/// Floor itself: adding 1.5 * 2^52 to |s| < 2^51 leaves a double whose last bit counts ones. The
/// mode decides which neighbour of s it is; comparing it to s (the subtraction is exact) tells
/// whether to step back, and the integer is read off the bits. No conversion instruction, whose
/// 64-bit form SSE2 has no vector of, and no range: compilers vectorise the whole.
template <rounding R, int Shift, std::int64_t Lowest, std::int64_t Highest>
inline std::int64_t quotient_by_double(std::int32_t numerator, std::int32_t divisor) noexcept {
  constexpr double scale = std::int64_t{1} << Shift;
  const double q = static_cast<double>(numerator) * scale / static_cast<double>(divisor);

  double sum = q;
  if constexpr (R == rounding::half_up) sum = q + 0.5;
  if constexpr (R == rounding::half_away) sum = q + (q < 0 ? -0.5 : 0.5);
  constexpr double highest = static_cast<double>(Highest) + 0.5;
  constexpr double lowest = static_cast<double>(Lowest);
  sum = sum > lowest ? sum : lowest;
  sum = sum < highest ? sum : highest;

  constexpr double ones = 0x1.8p52;
  const double placed = sum + ones;
  const double neighbour = placed - ones;
  const std::int64_t integer =
      std::bit_cast<std::int64_t>(placed) - std::bit_cast<std::int64_t>(ones);
  if constexpr (R == rounding::half_up || R == rounding::floor) {
    return integer - (neighbour > sum ? 1 : 0);
  } else {
    const std::int64_t outward = sum < 0 ? neighbour < sum : neighbour > sum;
    return sum < 0 ? integer + outward : integer - outward;
  }
}

/// No bounds: every quotient of two stored integers is within them.
inline constexpr std::int64_t any_quotient = std::int64_t{1} << 48;

/// numerator * 2^Shift / divisor rounded by rule R. `divisor` is not zero, Shift <= 16.
template <rounding R, int Shift>
constexpr std::int64_t rounded_quotient(std::int32_t numerator, std::int32_t divisor) noexcept {
  if (hardware_double && !std::is_constant_evaluated()) {
    return quotient_by_double<R, Shift, -any_quotient, any_quotient>(numerator, divisor);
  }
  return quotient_by_integers<R, Shift>(numerator, divisor);
}

/// The same, brought into the range of Raw.
template <class Raw, rounding R, int Shift>
constexpr Raw saturated_quotient(std::int32_t numerator, std::int32_t divisor) noexcept {
  constexpr std::int64_t lowest = std::numeric_limits<Raw>::min();
  constexpr std::int64_t highest = std::numeric_limits<Raw>::max();
  if (hardware_double && !std::is_constant_evaluated()) {
    return static_cast<Raw>(quotient_by_double<R, Shift, lowest, highest>(numerator, divisor));
  }
  const std::int64_t exact = quotient_by_integers<R, Shift>(numerator, divisor);
  return static_cast<Raw>(exact < lowest ? lowest : exact > highest ? highest : exact);
}

}  // namespace fixed::detail
