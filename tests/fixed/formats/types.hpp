/// @file
/// The formats that the tests of this folder cover: every width, signed and unsigned, with no, few,
/// all but one and all bits after the point.
#pragma once

#include <cstdint>

#include "fixed/number.hpp"
#include "tests/support/each_type.hpp"

namespace formats {

inline constexpr fixproof::policy even_saturate{.multiply = fixproof::rounding::half_even,
                                                .divide = fixproof::rounding::half_even,
                                                .range = fixproof::overflow::saturate};
inline constexpr fixproof::policy away_trap{.multiply = fixproof::rounding::half_away,
                                            .divide = fixproof::rounding::half_away,
                                            .range = fixproof::overflow::trap};
inline constexpr fixproof::policy truncate_saturate{.multiply = fixproof::rounding::truncate,
                                                    .divide = fixproof::rounding::truncate,
                                                    .range = fixproof::overflow::saturate};
inline constexpr fixproof::policy ceiling_saturate{.multiply = fixproof::rounding::ceiling,
                                                   .divide = fixproof::rounding::ceiling,
                                                   .range = fixproof::overflow::saturate};
inline constexpr fixproof::policy floor_wrap{.multiply = fixproof::rounding::floor,
                                             .divide = fixproof::rounding::floor};
/// Products wrap and quotients saturate, as those of Doom; sums throw.
inline constexpr fixproof::policy mixed{.multiply = fixproof::rounding::floor,
                                        .divide = fixproof::rounding::truncate,
                                        .range = fixproof::overflow::trap,
                                        .products = fixproof::overflow::wrap,
                                        .quotients = fixproof::overflow::saturate};

/// The divides of processors.
inline constexpr fixproof::policy whole_divisor{.multiply = fixproof::rounding::floor,
                                                .divide = fixproof::rounding::half_away,
                                                .divisor = fixproof::divisor_width::whole_part,
                                                .fault = fixproof::divide_fault::zero_divisor};
inline constexpr fixproof::policy signed_fault{.divide = fixproof::rounding::truncate,
                                               .fault = fixproof::divide_fault::signed_quotient};
inline constexpr fixproof::policy unsigned_fault{
    .divide = fixproof::rounding::half_away, .fault = fixproof::divide_fault::unsigned_quotient};

using fixproof::number;

using narrow =
    testing::Types<number<std::int8_t, 0, even_saturate>, number<std::int8_t, 4>,
                   number<std::int8_t, 7, away_trap>, number<std::int8_t, 8, truncate_saturate>,
                   number<std::int8_t, 8, floor_wrap>, number<std::uint8_t, 0, mixed>,
                   number<std::int8_t, 4, ceiling_saturate>,
                   number<std::uint8_t, 5, ceiling_saturate>,
                   number<std::uint8_t, 3, even_saturate>, number<std::uint8_t, 8>,
                   number<std::int8_t, 4, whole_divisor>, number<std::int8_t, 5, signed_fault>,
                   number<std::int8_t, 3, unsigned_fault>, number<std::uint8_t, 4, unsigned_fault>>;

using wide = testing::Types<
    number<std::int8_t, 4, mixed>, number<std::int16_t, 8, even_saturate>, number<std::int16_t, 15>,
    number<std::uint16_t, 16, away_trap>, number<std::int32_t, 0, mixed>,
    number<std::int32_t, 0, even_saturate>, number<std::int32_t, 8, floor_wrap>,
    number<std::int32_t, 16, even_saturate>, number<std::int32_t, 16, mixed>,
    number<std::int32_t, 24, truncate_saturate>, number<std::int32_t, 16, ceiling_saturate>,
    number<std::int64_t, 40, ceiling_saturate>, number<std::int32_t, 30>,
    number<std::int32_t, 31, even_saturate>, number<std::int32_t, 32, away_trap>,
    number<std::uint32_t, 0>, number<std::uint32_t, 16, mixed>,
    number<std::uint32_t, 32, even_saturate>, number<std::int64_t, 0, away_trap>,
    number<std::int64_t, 16>, number<std::int64_t, 32, even_saturate>,
    number<std::int64_t, 62, truncate_saturate>, number<std::int64_t, 63, floor_wrap>,
    number<std::int64_t, 64, even_saturate>, number<std::uint64_t, 0, mixed>,
    number<std::uint64_t, 32>, number<std::uint64_t, 64, away_trap>>;

}  // namespace formats
