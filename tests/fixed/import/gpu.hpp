// What the kernels share: numbers from and to words.
#pragma once

#include <array>
#include <cstdint>
#include <numbers>

#include "fixed/fixed.hpp"

namespace {

using saturated_32 = fixproof::q16_16_saturating;
using trapping_32 = fixproof::q16_16_trapping;
using assembly_32 = fixproof::q16_16_i386;
using small = fixproof::q8_8;
using exact_64 = fixproof::q32_32;
using natural_32 = fixproof::number<std::uint32_t, 16>;
inline constexpr fixproof::policy even_ties{.multiply = fixproof::rounding::half_even,
                                            .divide = fixproof::rounding::half_even};
using even_32 = fixproof::number<std::int32_t, 16, even_ties>;
using fixproof::q16_16;
using fixproof::q2_30;

template <class Raw, int Bits, fixproof::policy Rules>
constexpr std::int64_t word(fixproof::number<Raw, Bits, Rules> x) {
  return static_cast<std::int64_t>(x.raw());
}
constexpr std::int64_t word(std::int64_t x) { return x; }

constexpr double double_of(std::int64_t bits) { return __builtin_bit_cast(double, bits); }
constexpr float float_of(std::int32_t bits) { return __builtin_bit_cast(float, bits); }
constexpr std::int64_t bits_of(double x) { return __builtin_bit_cast(std::int64_t, x); }

template <class Number>
constexpr Number sum_of_products(Number x, Number y, Number z) {
  const std::array<Number, 3> a{x, y, z};
  const std::array<Number, 3> b{y, z, x};
  return dot(a, b);
}

template <class Number>
constexpr Number accumulated_products(Number x, Number y, Number z) {
  fixproof::accumulator<Number> sum;
  sum.add_product(x, y);
  sum.add_product(y, z);
  return sum.result();
}

template <class Number>
constexpr Number number_of(std::int64_t word) {
  return Number::from_raw(static_cast<typename Number::raw_type>(word));
}

}  // namespace
