/// @file
/// Names for formats other than 16.16 and 8.8, and for any format under another policy.
///
/// qW_F has W bits before the point, the sign included, and F after it; uW_F has no sign. All of
/// them round to nearest, ties up, and wrap, as q16_16 does.
#pragma once

#include <cstdint>

#include "fixed/number.hpp"
#include "fixed/policy.hpp"

namespace fixproof {

/// The format of Number under another policy.
///
///     using precise = with_policy<q2_30, policies::saturating>;
///     static_assert(precise(1.5) + precise(1.5) == std::numeric_limits<precise>::max());
template <class Number, policy Rules>
using with_policy = number<typename Number::raw_type, Number::fraction_bits, Rules>;

/// @name 8 bits
/// \{

/// Two's complement, or unsigned.
using q8_0 = number<std::int8_t, 0>;
using q4_4 = number<std::int8_t, 4>;
using q1_7 = number<std::int8_t, 7>;
using u4_4 = number<std::uint8_t, 4>;
using u0_8 = number<std::uint8_t, 8>;
/// \}

/// @name 16 bits
/// \{

/// Two's complement, or unsigned.
using q12_4 = number<std::int16_t, 4>;
using q4_12 = number<std::int16_t, 12>;
using q2_14 = number<std::int16_t, 14>;
using q1_15 = number<std::int16_t, 15>;
using u8_8 = number<std::uint16_t, 8>;
using u1_15 = number<std::uint16_t, 15>;
using u0_16 = number<std::uint16_t, 16>;
/// \}

/// @name 32 bits
/// \{

/// Two's complement, or unsigned.
using q32_0 = number<std::int32_t, 0>;
using q26_6 = number<std::int32_t, 6>;
using q24_8 = number<std::int32_t, 8>;
using q20_12 = number<std::int32_t, 12>;
using q8_24 = number<std::int32_t, 24>;
using q4_28 = number<std::int32_t, 28>;
using q2_30 = number<std::int32_t, 30>;
using q1_31 = number<std::int32_t, 31>;
using u24_8 = number<std::uint32_t, 8>;
using u16_16 = number<std::uint32_t, 16>;
using u8_24 = number<std::uint32_t, 24>;
using u1_31 = number<std::uint32_t, 31>;
using u0_32 = number<std::uint32_t, 32>;
/// \}

/// @name 64 bits
/// \{

/// Two's complement, or unsigned.
using q48_16 = number<std::int64_t, 16>;
using q40_24 = number<std::int64_t, 24>;
using q32_32 = number<std::int64_t, 32>;
using q16_48 = number<std::int64_t, 48>;
using q2_62 = number<std::int64_t, 62>;
using q1_63 = number<std::int64_t, 63>;
using u48_16 = number<std::uint64_t, 16>;
using u32_32 = number<std::uint64_t, 32>;
using u0_64 = number<std::uint64_t, 64>;
/// \}

}  // namespace fixproof
