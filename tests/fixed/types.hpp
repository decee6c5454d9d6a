/// @file
/// The number types that every arithmetic test covers.
#pragma once

#include <array>

#include "fixed/number.hpp"
#include "tests/support/test.hpp"

namespace fixproof {

/// Policies that no preset has. With the aliases they cover each rounding under each overflow.
inline constexpr policy floor_and_saturate{
    .multiply = rounding::floor, .divide = rounding::floor, .range = overflow::saturate};
inline constexpr policy truncate_and_saturate{
    .multiply = rounding::truncate, .divide = rounding::truncate, .range = overflow::saturate};
inline constexpr policy away_and_saturate{
    .multiply = rounding::half_away, .divide = rounding::half_away, .range = overflow::saturate};
inline constexpr policy truncate_and_trap{
    .multiply = rounding::truncate, .divide = rounding::truncate, .range = overflow::trap};
inline constexpr policy floor_and_wrap{.multiply = rounding::floor, .divide = rounding::floor};
inline constexpr policy away_and_wrap{.multiply = rounding::half_away,
                                      .divide = rounding::half_away};
inline constexpr policy whole_divisor_saturating{.range = overflow::saturate,
                                                 .divisor = divisor_width::whole_part};
inline constexpr policy fault_before_trap{.range = overflow::trap,
                                          .fault = divide_fault::unsigned_quotient};

inline constexpr policy fault_and_saturate{.range = overflow::saturate,
                                           .fault = divide_fault::signed_quotient};
inline constexpr policy zero_fault_and_trap{
    .divide = rounding::truncate, .range = overflow::trap, .fault = divide_fault::zero_divisor};

/// Every preset, and every policy above.
using every_type = testing::Types<
    q16_16, q16_16_saturating, q16_16_trapping, q16_16_i386, q16_16_i386_mul_rounded,
    q16_16_i386_div_rounded, q16_16_i386_unrounded, q16_16_i8088, q16_16_i8088_mul_rounded,
    q16_16_i8088_div_rounded, q16_16_i8088_unrounded, q8_8, q8_8_saturating, q8_8_trapping,
    q8_8_i386, q8_8_i386_mul_rounded, q8_8_i386_div_rounded, q8_8_i386_unrounded, q8_8_i8088,
    q8_8_i8088_mul_rounded, q8_8_i8088_div_rounded, q8_8_i8088_unrounded,
    number<std::int32_t, 16, floor_and_saturate>, number<std::int32_t, 16, truncate_and_saturate>,
    number<std::int32_t, 16, away_and_saturate>, number<std::int32_t, 16, truncate_and_trap>,
    number<std::int32_t, 16, floor_and_wrap>, number<std::int32_t, 16, away_and_wrap>,
    number<std::int32_t, 16, whole_divisor_saturating>, number<std::int32_t, 16, fault_before_trap>,
    number<std::int32_t, 16, fault_and_saturate>, number<std::int32_t, 16, zero_fault_and_trap>,
    number<std::int16_t, 8, floor_and_saturate>,
    number<std::int16_t, 8, whole_divisor_saturating> >;

#if defined(FIXPROOF_FEW_TYPES)
// A program that repeats tests under other flags looks at code that does not depend on the type.
using all_types =
    testing::Types<q16_16, q16_16_saturating, q16_16_trapping, q16_16_i386, q16_16_i386_unrounded,
                   q16_16_i8088_unrounded, q8_8, q8_8_trapping>;
using dividing_types = all_types;
using some_types = all_types;
#elif defined(FIXPROOF_NIGHTLY)
using all_types = every_type;
using dividing_types = every_type;
using some_types = every_type;
#else
/// Stand for every type: each two rules that some type has, and each rule with each width, occur
/// together in one of these. A fault that three rules have to meet for is left to the night.
using all_types = testing::Types<
    q16_16, q16_16_saturating, q16_16_i386, q16_16_i386_div_rounded, q16_16_i8088_mul_rounded,
    q16_16_i8088_unrounded, q8_8_trapping, q8_8_i386, q8_8_i386_unrounded, q8_8_i8088,
    q8_8_i8088_div_rounded, number<std::int32_t, 16, truncate_and_saturate>,
    number<std::int32_t, 16, away_and_saturate>, number<std::int32_t, 16, truncate_and_trap>,
    number<std::int32_t, 16, floor_and_wrap>, number<std::int32_t, 16, fault_before_trap>,
    number<std::int32_t, 16, fault_and_saturate>, number<std::int32_t, 16, zero_fault_and_trap>,
    number<std::int16_t, 8, floor_and_saturate>,
    number<std::int16_t, 8, whole_divisor_saturating> >;
/// The same for tests of division alone, which the rounding of products does not touch.
using dividing_types = testing::Types<
    q16_16, q16_16_saturating, q16_16_i386, q16_16_i8088_unrounded, q8_8_trapping, q8_8_i386,
    q8_8_i386_mul_rounded, q8_8_i8088, number<std::int32_t, 16, truncate_and_saturate>,
    number<std::int32_t, 16, away_and_saturate>, number<std::int32_t, 16, floor_and_wrap>,
    number<std::int32_t, 16, fault_before_trap>, number<std::int32_t, 16, fault_and_saturate>,
    number<std::int32_t, 16, zero_fault_and_trap>, number<std::int16_t, 8, floor_and_saturate>,
    number<std::int16_t, 8, whole_divisor_saturating> >;
/// The same for tests without division.
using some_types = testing::Types<
    q16_16, q16_16_saturating, q16_16_i386, q16_16_i8088_unrounded, q8_8_saturating, q8_8_trapping,
    q8_8_i386_div_rounded, q8_8_i8088, q8_8_i8088_div_rounded,
    number<std::int32_t, 16, floor_and_saturate>, number<std::int32_t, 16, truncate_and_saturate>,
    number<std::int32_t, 16, away_and_saturate>, number<std::int32_t, 16, truncate_and_trap> >;

/// The rules of a type, the width among them, as small integers.
using Rules = std::array<int, 6>;
template <class N>
constexpr Rules rules_of() {
  constexpr policy p = N::rules;
  return {static_cast<int>(p.multiply), static_cast<int>(sizeof(N)), static_cast<int>(p.range),
          static_cast<int>(p.divide),   static_cast<int>(p.divisor), static_cast<int>(p.fault)};
}

/// Whether any two rules of a type of `Every` occur together in a type of `Few`.
/// @param first, last which rules, by their place
template <class... Every, class... Few>
constexpr bool has_each_pair(testing::Types<Every...> /*every*/, testing::Types<Few...> /*few*/,
                             std::size_t first, std::size_t last) {
  constexpr std::array few{rules_of<Few>()...};
  for (const Rules& wanted : {rules_of<Every>()...}) {
    for (std::size_t i = first; i <= last; ++i) {
      for (std::size_t k = first; k < i; ++k) {
        bool found = false;
        for (const Rules& r : few) found = found || (r[i] == wanted[i] && r[k] == wanted[k]);
        if (!found) return false;
      }
    }
  }
  return true;
}
static_assert(has_each_pair(every_type(), all_types(), 0, 5));
static_assert(has_each_pair(every_type(), dividing_types(), 1, 5));
static_assert(has_each_pair(every_type(), some_types(), 0, 2));
#endif

}  // namespace fixproof
