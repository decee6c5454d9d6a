/// @file
/// The rounded quotient of two stored integers, exact, from integers or hardware doubles.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/bit_cast.hpp"
#include "fixed/detail/bits.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/rounding.hpp"

namespace fixproof::detail {

/// 1 for a negative integer and 0 for any other.
FIXED_ALWAYS_INLINE constexpr std::int64_t one_if_negative(std::int32_t x) noexcept {
  return static_cast<std::int64_t>(static_cast<std::uint32_t>(x) >> 31);
}

/// numerator * 2^Shift / divisor rounded by rule Rounding, in integers. Rounding is not half_even.
///
/// One division without a branch, and as little as possible before and after it, because a chain of
/// divisions waits for all of it. Let Q be the exact quotient and t the truncated quotient of its
/// double, 2 Q.
///
/// half_up is floor((floor(2 Q) + 1) / 2). If Q is not negative, floor(2 Q) = t. If Q is negative,
/// the numerator of 2 Q is first moved by 1 toward zero, so that t = floor(2 Q) + 1, whether 2 Q is
/// an integer or not. If Q is zero but counts as negative, the result is floor(t / 2) for t = 0 or
/// 1.
///
/// half_away is floor((t + 1) / 2) for Q >= 0. For Q < 0 it is ceil((t - 1) / 2) = floor(t / 2).
///
/// @pre divisor is not zero, Shift <= 30
template <rounding Rounding, int Shift>
FIXED_ALWAYS_INLINE constexpr std::int64_t quotient_by_integers(std::int32_t numerator,
                                                                std::int32_t divisor) noexcept {
  const std::int64_t below = one_if_negative(numerator);
  const std::int64_t divisor_below = one_if_negative(divisor);
  if constexpr (Rounding == rounding::half_up || Rounding == rounding::half_away) {
    std::int64_t twice = std::int64_t{numerator} * (std::int64_t{2} << Shift);
    if constexpr (Rounding == rounding::half_up) twice = twice + below - divisor_below;
    return (twice / divisor + one_if_negative(~(numerator ^ divisor))) >> 1;
  } else {
    const std::int64_t scaled = std::int64_t{numerator} * (std::int64_t{1} << Shift);
    const bool negative = below != divisor_below;
    const std::int64_t truncated = scaled / divisor;
    // A negative quotient that is not an integer has a floor below its truncation, and a positive
    // one a ceiling above it.
    if constexpr (Rounding == rounding::floor) {
      return truncated - std::int64_t{scaled % divisor != 0 && negative};
    } else if constexpr (Rounding == rounding::ceiling) {
      return truncated + std::int64_t{scaled % divisor != 0 && !negative};
    } else {
      return truncated;
    }
  }
}

/// floor(rest 2^Bits / d), for Bits <= 16. Leaves the remainder in rest.
///
/// Let D be the upper half of d, and A the upper 16 + Bits bits of rest. floor(A / D) is at most 2
/// above the digit, because the top bit of d is set, and never below it (theorems A and B of
/// section 4.3.1 of Knuth, The Art of Computer Programming). It is at most 2^16 + 1, so its product
/// with the lower half of d has 32 bits.
/// @pre rest < d, and d has its top bit set
template <int Bits>
constexpr std::uint32_t next_digit(std::uint32_t& rest, std::uint32_t d) noexcept {
  static_assert(0 < Bits && Bits <= 16);
  constexpr std::uint32_t lower_half = 0xffff;
  const std::uint32_t leading = rest >> (16 - Bits);
  const std::uint32_t upper = d >> 16;
  std::uint32_t digit = leading / upper;
  const std::uint32_t above = leading % upper << 16 | (rest << Bits & lower_half);
  const std::uint32_t taken = digit * (d & lower_half);
  rest = above - taken;
  if (above < taken) {
    // Below zero, modulo 2^32, until a sum wraps, which leaves less than d.
    do {
      --digit;
      rest += d;
    } while (rest >= d);
  }
  return digit;
}

/// quotient_by_integers() in words of 32 bits, for processors that divide no longer ones. It
/// divides the magnitudes: first the whole part, then Shift bits after the point, from the upper
/// ones on.
/// @pre divisor is not zero, Shift <= 30
template <rounding Rounding, int Shift>
constexpr std::int64_t quotient_by_words(std::int32_t numerator, std::int32_t divisor) noexcept {
  const bool negative = (numerator ^ divisor) < 0;
  const std::uint32_t n = negated_if(numerator < 0, static_cast<std::uint32_t>(numerator));
  std::uint32_t d = negated_if(divisor < 0, static_cast<std::uint32_t>(divisor));
  std::uint64_t quotient = n / d;
  // The remainder and the divisor times the same power of two.
  const int zeros = leading_zeros(d);
  std::uint32_t rest = n % d << zeros;
  d <<= zeros;
  constexpr int last = Shift < 16 ? Shift : 16;
  if constexpr (Shift > last) {
    constexpr int first = Shift - last;
    quotient = quotient << first | next_digit<first>(rest, d);
  }
  if constexpr (last > 0) quotient = quotient << last | next_digit<last>(rest, d);
  quotient += std::uint64_t{grows<Rounding>(rest, d, negative, is_odd(quotient))};
  return static_cast<std::int64_t>(negated_if(negative, quotient));
}

/// numerator * 2^Shift / divisor rounded by rule Rounding, in the integers that the processor
/// divides.
template <rounding Rounding, int Shift>
FIXED_ALWAYS_INLINE constexpr std::int64_t integer_quotient(std::int32_t numerator,
                                                            std::int32_t divisor) noexcept {
  if constexpr (divides_in_words) {
    return quotient_by_words<Rounding, Shift>(numerator, divisor);
  } else {
    return quotient_by_integers<Rounding, Shift>(numerator, divisor);
  }
}

/// The upper half of the bits: sign, exponent and the top of the significand.
inline std::int32_t upper_bits(double x) noexcept {
  return static_cast<std::int32_t>(bit_cast<std::uint64_t>(x) >> 32);
}

/// The divisor, or 1 in place of 0.
constexpr std::int32_t one_for_zero(std::int32_t divisor) noexcept {
  return divisor + std::int32_t{divisor == 0};
}

/// The quotient by one double division, plus a half if Rounding rounds to nearest. Its floor, or
/// its trunc for half_away and truncate, is the rounded quotient. A divisor of 0 counts as 1.
///
/// Bit-identical to integer division for every operand and every rounding mode of the processor:
///
/// Let Q = N / D be the exact quotient, N = numerator * 2^Shift, |N| <= 2^47, 0 < |D| <= 2^31, and
/// q its double in the current mode: |q - Q| < |Q| 2^-52 = |N / D| 2^-52 <= 2^-5 / |D|. If Q is an
/// integer or an integer plus a half, it has at most 48 bits, so q = Q and q +- 1/2 is exact.
///
/// Otherwise Q is at least 1 / |D| from every integer and 1 / (2 |D|) from every half. Adding 1/2
/// rounds once more, by less than (|Q| + 1/2) 2^-52 <= 2^-5 / |D| + 2^-53. Both errors together are
/// less than 2^-4 / |D| + 2^-53 < 1 / (4 |D|), so the computed sum stays on the same side of every
/// integer as the exact one, and at least 1 / (4 |D|) >= 2^-33 away from it.
///
/// So floor and trunc of the computed sum are those of the exact sum.
template <rounding Rounding, int Shift>
inline double quotient_sum(std::int32_t numerator, std::int32_t divisor) noexcept {
  constexpr double scale = std::int64_t{1} << Shift;
#if defined(__SSE4_1__)
  // Vector registers replace a 0 with the least work here. With FMA, compilers fuse the scaling of
  // the quotient with the sum; clang++ needs both in one expression. The scale is a power of two,
  // so it rounds nothing.
  const auto d = static_cast<double>(divisor);
  const double q = static_cast<double>(numerator) / (d + (d == 0 ? 1.0 : 0.0));
  constexpr double unit = scale;
#else
  const double q =
      static_cast<double>(numerator) * scale / static_cast<double>(one_for_zero(divisor));
  constexpr double unit = 1;
#endif
  if constexpr (Rounding == rounding::half_up) {
    return q * unit + 0.5;
  } else if constexpr (Rounding == rounding::half_away) {
    return q * unit + copysign(0.5, q);
  } else {
    return q * unit;
  }
}

/// Whether placed_floor() rounds by an instruction. It is a template parameter, so that functions
/// of translation units with other flags have other names: the linker keeps one function of a name.
#if defined(__SSE4_1__) && (defined(__GNUC__) || defined(__clang__)) || \
    defined(__clang__) && defined(__aarch64__)
inline constexpr bool rounds_doubles = true;
#else
inline constexpr bool rounds_doubles = false;
#endif

/// The double to which placed_floor<Plus, Shift>() adds.
template <int Shift, bool Rounds = rounds_doubles>
inline constexpr double base_of_floors = 0x1.8p52 / (Rounds ? 1.0 : std::int64_t{1} << Shift);

/// Its bits. The low 51 are zero.
template <int Shift, bool Rounds = rounds_doubles>
inline constexpr auto place_of_floors = bit_cast<std::uint64_t>(base_of_floors<Shift, Rounds>);

/// place_of_floors + floor(x 2^Shift) + Plus, if that floor is below 2^50 in magnitude. For other x
/// and for NaN, differs from place_of_floors by at least 2^50 - 1.
///
/// It works in every rounding mode of the processor. It has no branch and no 64-bit conversion,
/// which SSE2 has only for scalars, so compilers vectorise it.
template <int Plus, int Shift = 0, bool Rounds = rounds_doubles>
inline std::uint64_t placed_floor(double x) noexcept {
  static_assert(Plus == 0 || Plus == 1);
  constexpr double base = base_of_floors<Shift, Rounds>;
  if constexpr (Rounds) {
    x *= static_cast<double>(std::int64_t{1} << Shift);
#if defined(__clang__)
    return bit_cast<std::uint64_t>(__builtin_floor(x) + (base + Plus));
#elif defined(__GNUC__)
    // g++ 12 vectorises no floor. The mode decides whether this is the floor or the ceiling of x.
    const double neighbour = __builtin_rint(x);
    return bit_cast<std::uint64_t>(neighbour + (x < neighbour ? base + (Plus - 1) : base + Plus));
#endif
  } else {
    // The last bit of the sum has weight 2^-Shift, so the sum less the base is a floor or a
    // ceiling, too.
    const double sum = x + base;
#if defined(__clang__)
    const std::uint64_t above = bit_cast<std::uint64_t>(sum) + Plus;
    return x < sum - base ? above - 1 : above;
#else
    // In doubles, because g++ -O2 vectorises no loop of unknown length, and a scalar reaches an
    // integer register late.
    constexpr double unit = base * 0x1p-52 / 1.5;
    if constexpr (Plus == 0) {
      // A sum, because g++ -O2 makes a branch of the difference, and random operands mispredict it.
      return bit_cast<std::uint64_t>(sum + (x < sum - base ? -unit : 0.0));
    } else {
      return bit_cast<std::uint64_t>(sum + (sum - base <= x ? unit : 0.0));
    }
#endif
  }
}

/// Whether rule Rounding is a floor after adding the half; otherwise it is a trunc.
template <rounding Rounding>
inline constexpr bool rounds_by_floor =
    Rounding == rounding::half_up || Rounding == rounding::floor;

/// numerator * 2^Shift / divisor rounded by rule Rounding. A divisor of 0 counts as 1.
/// @pre Shift <= 16
template <rounding Rounding, int Shift>
constexpr std::int64_t rounded_quotient(std::int32_t numerator, std::int32_t divisor) noexcept {
  // if constexpr: without hardware doubles even dead code must not contain a double.
  if constexpr (hardware_double) {
    if (!std::is_constant_evaluated()) {
      // At most 2^47 and a half.
      const double sum = quotient_sum<Rounding, Shift>(numerator, divisor);
      if constexpr (rounds_by_floor<Rounding>) {
        return static_cast<std::int64_t>(placed_floor<0>(sum) - place_of_floors<0>);
      } else {
        return static_cast<std::int64_t>(sum);
      }
    }
  }
  return integer_quotient<Rounding, Shift>(numerator, one_for_zero(divisor));
}

/// The low 32 bits of floor(x). Those of place_of_floors are zero, so nothing is subtracted: g++ 12
/// would subtract a constant of 64 bits that it cannot leave out.
/// @pre that floor is below 2^50 in magnitude
inline std::int32_t low_bits_of_floor(double x) noexcept {
  return static_cast<std::int32_t>(placed_floor<0>(x));
}

/// The low 32 bits of rounded_quotient(), with its preconditions.
template <rounding Rounding, int Shift>
constexpr std::int32_t wrapped_quotient(std::int32_t numerator, std::int32_t divisor) noexcept {
  if constexpr (hardware_double && rounds_by_floor<Rounding>) {
    if (!std::is_constant_evaluated()) {
      return low_bits_of_floor(quotient_sum<Rounding, Shift>(numerator, divisor));
    }
  }
  return static_cast<std::int32_t>(rounded_quotient<Rounding, Shift>(numerator, divisor));
}

/// rounded_quotient(), saturated to the range of Raw.
template <class Raw, rounding Rounding, int Shift>
constexpr std::int32_t saturated_quotient(std::int32_t numerator, std::int32_t divisor) noexcept {
  constexpr std::int32_t highest = (std::numeric_limits<Raw>::max)();
  constexpr std::int32_t lowest = (std::numeric_limits<Raw>::min)();
  if constexpr (hardware_double && rounds_by_floor<Rounding>) {
    if (!std::is_constant_evaluated()) {
      // Out of range if the sum is below `lowest` (or is a negative zero above it: the same end) or
      // has reached `highest` + 1. At such a quotient the divisor is at most 2^16, so a sum that
      // has not reached it stays 2^-18 below.
      constexpr double below_end = static_cast<double>(highest) + (1 - 0x1p-19);
      const double sum = quotient_sum<Rounding, Shift>(numerator, divisor);
      // Below, `end` replaces what is out of range.
      const std::int32_t low = low_bits_of_floor(sum);
      const std::int32_t end = ((numerator ^ divisor) >> 31) ^ highest;
      const std::int32_t out = (upper_bits(sum - lowest) | upper_bits(below_end - sum)) >> 31;
      return (low & ~out) | (end & out);
    }
  }
  const std::int64_t quotient = rounded_quotient<Rounding, Shift>(numerator, divisor);
  return static_cast<std::int32_t>(quotient < lowest    ? lowest
                                   : quotient > highest ? highest
                                                        : quotient);
}

}  // namespace fixproof::detail
