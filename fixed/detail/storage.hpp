/// \file
/// The integer types that store a number.
#pragma once

#include <cstdint>

namespace fixproof::detail {

/// The types for one format: 8.8 in 16 bits, 16.16 in 32.
template <int FractionBits>
struct storage;

template <>
struct storage<8> {
  using raw = std::int16_t;
  using wide = std::int32_t;
};

template <>
struct storage<16> {
  using raw = std::int32_t;
  using wide = std::int64_t;
};

/// The stored integer: the value times 2^FractionBits.
template <int FractionBits>
using raw_t = typename storage<FractionBits>::raw;

/// Holds the product of two stored integers, in units of 2^(-2 FractionBits), with one bit to
/// spare.
template <int FractionBits>
using wide_t = typename storage<FractionBits>::wide;

}  // namespace fixproof::detail
