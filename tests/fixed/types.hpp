/// \file
/// The number types that every arithmetic test covers.
#pragma once

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

#ifdef FIXPROOF_FEW_TYPES
// A program that repeats tests under other flags looks at code that does not depend on the type.
using all_types = testing::Types<q16_16, q16_16_saturating, q16_16_trapping, q16_16_i386,
                                 q16_16_i8088_unrounded, q8_8, q8_8_trapping>;
using dividing_types = all_types;
using some_types = all_types;
#else
using all_types = testing::Types<
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

/// Whether two policies differ at most in products.
constexpr bool divide_alike(policy a, const policy& b) {
  a.multiply = b.multiply;
  return a == b;
}
// Each preset that dividing_types lacks divides like a listed one.
static_assert(divide_alike(policies::i386_mul_rounded, policies::i386_unrounded));
static_assert(divide_alike(policies::i386_div_rounded, policies::i386_rounded));
static_assert(divide_alike(policies::i8088_mul_rounded, policies::i8088_unrounded));
static_assert(divide_alike(policies::i8088_div_rounded, policies::i8088_rounded));

/// Covers each distinct division, for tests of division alone.
using dividing_types = testing::Types<
    q16_16, q16_16_saturating, q16_16_trapping, q16_16_i386, q16_16_i386_unrounded, q16_16_i8088,
    q16_16_i8088_unrounded, q8_8, q8_8_saturating, q8_8_trapping, q8_8_i386, q8_8_i386_unrounded,
    q8_8_i8088, q8_8_i8088_unrounded, number<std::int32_t, 16, floor_and_saturate>,
    number<std::int32_t, 16, truncate_and_saturate>, number<std::int32_t, 16, away_and_saturate>,
    number<std::int32_t, 16, truncate_and_trap>, number<std::int32_t, 16, floor_and_wrap>,
    number<std::int32_t, 16, away_and_wrap>, number<std::int32_t, 16, whole_divisor_saturating>,
    number<std::int32_t, 16, fault_before_trap>, number<std::int32_t, 16, fault_and_saturate>,
    number<std::int32_t, 16, zero_fault_and_trap>, number<std::int16_t, 8, floor_and_saturate>,
    number<std::int16_t, 8, whole_divisor_saturating> >;

/// Covers each distinct rounding of products under each overflow, for tests without division.
using some_types =
    testing::Types<q16_16, q16_16_saturating, q16_16_trapping, q16_16_i386_unrounded, q16_16_i8088,
                   q16_16_i8088_unrounded, number<std::int32_t, 16, floor_and_saturate>,
                   number<std::int32_t, 16, truncate_and_trap>,
                   number<std::int32_t, 16, away_and_saturate>, q8_8, q8_8_saturating,
                   q8_8_trapping, q8_8_i8088, q8_8_i8088_unrounded>;
#endif

}  // namespace fixproof
