/// \file
/// Converts floats and doubles to stored integers of at most 32 bits with hardware doubles, in code
/// that compilers vectorise. Bit-identical to detail::scale() and detail::narrow().
///
/// Constant expressions use it, too. If the constructor had std::is_constant_evaluated(), g++ 12
/// would initialise global numbers only when the program starts.
#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/bit_cast.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// Whether converted() supports the conversion.
template <class Raw, overflow O>
inline constexpr bool has_fast_conversion = hardware_double&& bits_of<Raw> <= 32 &&
                                            (O == overflow::wrap || O == overflow::saturate);

/// Returns 2^exponent, for exponents of normal numbers.
constexpr double power_of_two(int exponent) noexcept {
  return bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// Returns `yes` if the condition holds, else `no`. g++ vectorises masks but not conditions. Masks
/// move a single double to an integer register and back, which takes longer than a branch. So g++
/// gets masks only if the processor has the instructions to vectorise the rest.
template <class Word>
constexpr Word select(bool condition, Word yes, Word no) noexcept {
#if defined(__AVX2__) && !defined(__clang__)
  if constexpr (std::is_floating_point_v<Word>) {
    return bit_cast<double>(
        select(condition, bit_cast<std::uint64_t>(yes), bit_cast<std::uint64_t>(no)));
  } else {
    const Word mask = Word{0} - Word{condition};
    return (yes & mask) | (no & ~mask);
  }
#else
  return condition ? yes : no;
#endif
}

/// Returns x as a double. Under rounding::floor, a subnormal x gets a bit of its exponent set and
/// becomes normal, because processors may take subnormals for zero. Other rules round both to zero.
template <rounding R, binary_float Float>
constexpr double as_double(Float x) noexcept {
  if constexpr (R == rounding::floor) {
    using bits_type = std::conditional_t<sizeof(Float) == 4, std::uint32_t, std::uint64_t>;
    constexpr int sign = sizeof(Float) * 8 - 1;
    constexpr bits_type normal = bits_type{1} << (std::numeric_limits<Float>::digits - 1);
    const auto bits = bit_cast<bits_type>(x);
    const bits_type magnitude = bits & ((bits_type{1} << sign) - 1);
    const auto subnormal = select<bits_type>(magnitude - 1 < normal - 1, normal, 0);
    return static_cast<double>(bit_cast<Float>(static_cast<bits_type>(bits | subnormal)));
  } else {
    return static_cast<double>(x);
  }
}

/// Returns `twice` / 2 rounded by rule R, in the lower 32 bits, for |twice| < 2^51.
///
/// Adding 1.5 * 2^52 rounds `twice` to one of its neighbouring integers, which the rounding mode
/// chooses. The sign of the rest tells which neighbour it is. The rest is exact, or `twice` is so
/// small that rounding keeps the sign of the rest. So every rounding mode gives the same result.
/// \param negative whether the number was negative before a multiple of 2^36 was subtracted from it
template <rounding R>
constexpr std::uint64_t half_rounded(double twice, bool negative) noexcept {
  constexpr double ones = 0x1.8p52;
  const double placed = twice + ones;
  const double rest = twice - (placed - ones);
  const std::uint64_t neighbour = bit_cast<std::uint64_t>(placed) - bit_cast<std::uint64_t>(ones);
  const std::uint64_t floor = neighbour - std::uint64_t{rest < 0};
  if constexpr (R == rounding::half_up) {
    return (floor + 1) >> 1;
  } else if constexpr (R == rounding::floor) {
    return floor >> 1;
  } else if constexpr (R == rounding::half_even) {
    const std::uint64_t up = (floor + 1) >> 1;
    return up - (up & floor & std::uint64_t{!(rest < 0 || rest > 0)});
  } else {
    // Rounds a negative number like a positive one, with floor and ceiling exchanged.
    const std::uint64_t ceiling = neighbour + std::uint64_t{rest > 0};
    constexpr std::uint64_t up = R == rounding::half_away ? 1 : 0;
    return select<std::uint64_t>(negative, ceiling + 1 - up, floor + up) >> 1;
  }
}

/// Returns a float or double as a stored integer, rounded by rule R. See the constructor of number
/// for values out of range, infinities and NaN.
template <rounding R, overflow O, class Raw, int FractionBits, binary_float Float>
constexpr Raw converted(Float value) noexcept {
  constexpr std::uint64_t infinity = 0x7ff0000000000000;
  constexpr double lowest = (std::numeric_limits<Raw>::min)();
  constexpr double highest = (std::numeric_limits<Raw>::max)();
  const auto x = as_double<R>(value);
  const auto bits = bit_cast<std::uint64_t>(x);
  const std::uint64_t magnitude = bits & ~(std::uint64_t{1} << 63);
  const bool negative = bits >> 63 != 0;
  constexpr double twice_one = power_of_two(FractionBits + 1);
  if constexpr (O == overflow::saturate) {
    // The ends of the range are integers, so a number may be limited before it is rounded.
    // It is limited even before it is scaled, because a constant expression must not overflow.
    constexpr double least = 2 * lowest / twice_one;
    constexpr double most = 2 * highest / twice_one;
    const double number = select(magnitude > infinity, 0.0, x);
    const double limited = select(number < least, least, number);
    return static_cast<Raw>(
        half_rounded<R>(select(limited > most, most, limited) * twice_one, negative));
  } else {
    // From 2^85 ulp on, a number is a multiple of 2^32 ulp. From 2^50 ulp on, subtracting the
    // multiple of 2^36 next to `twice` is exact.
    constexpr auto all_multiples = bit_cast<std::uint64_t>(power_of_two(85 - FractionBits));
    constexpr auto large = bit_cast<std::uint64_t>(power_of_two(50 - FractionBits));
    constexpr double multiples = 0x1.8p88;
    const double twice = select(magnitude < all_multiples, x, 0.0) * twice_one;
    const double reduced = twice - ((twice + multiples) - multiples);
    const auto low = static_cast<std::uint32_t>(
        half_rounded<R>(select(magnitude < large, twice, reduced), negative));
    const std::uint32_t sign = 0U - std::uint32_t{negative};
    const auto positive_end = static_cast<std::uint32_t>((std::numeric_limits<Raw>::max)());
    const std::uint32_t end = std::is_signed_v<Raw> ? sign ^ positive_end : ~sign & positive_end;
    return static_cast<Raw>(select(magnitude == infinity, end, low));
  }
}

}  // namespace fixproof::detail
