/// @file
/// The number types for the tests of each stage.
#pragma once

#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"
#include "xsharp/arithmetic.hpp"

namespace pipeline {

#if defined(FIXPROOF_FEW_TYPES)
// Sanitizers watch the code of the stages, which is the same for every preset.
using all_types = testing::Types<double, fixproof::q16_16, fixproof::q16_16_trapping,
                                 fixproof::q16_16_i8088_unrounded>;
using multiplying_types = all_types;
#else
using all_types =
    testing::Types<double, fixproof::q16_16, fixproof::q16_16_saturating, fixproof::q16_16_trapping,
                   fixproof::q16_16_i386, fixproof::q16_16_i386_mul_rounded,
                   fixproof::q16_16_i386_div_rounded, fixproof::q16_16_i386_unrounded,
                   fixproof::q16_16_i8088, fixproof::q16_16_i8088_mul_rounded,
                   fixproof::q16_16_i8088_div_rounded, fixproof::q16_16_i8088_unrounded>;

/// One type per distinct arithmetic, for code that never divides.
using multiplying_types = testing::Types<double, fixproof::q16_16, fixproof::q16_16_saturating,
                                         fixproof::q16_16_trapping, fixproof::q16_16_i386_unrounded,
                                         fixproof::q16_16_i8088, fixproof::q16_16_i8088_unrounded>;
#endif

/// Whether two policies differ at most in division.
constexpr bool multiply_alike(fixproof::policy a, const fixproof::policy& b) {
  a.divide = b.divide;
  a.fault = b.fault;
  return a == b;
}
// Each preset that the longer list lacks multiplies, adds and subtracts like a listed one.
static_assert(multiply_alike(fixproof::policies::i386_rounded, fixproof::policies::wrapping));
static_assert(multiply_alike(fixproof::policies::i386_mul_rounded, fixproof::policies::wrapping));
static_assert(multiply_alike(fixproof::policies::i386_div_rounded,
                             fixproof::policies::i386_unrounded));
static_assert(multiply_alike(fixproof::policies::i8088_mul_rounded,
                             fixproof::policies::i8088_rounded));
static_assert(multiply_alike(fixproof::policies::i8088_div_rounded,
                             fixproof::policies::i8088_unrounded));

/// For code that only compares, since comparison of 16.16 numbers ignores the policy.
using comparing_types = testing::Types<double, fixproof::q16_16>;

/// For tests of whole scenes, which instantiate the pipeline once more for each type. It sees a
/// number only through xsharp::Arithmetic, which the tests of ArithmeticOf cover for every preset.
#if defined(FIXPROOF_NIGHTLY)
using scene_types = all_types;
#elif defined(FIXPROOF_FEW_TYPES)
using scene_types = testing::Types<double, fixproof::q16_16_i8088_unrounded>;
#else
using scene_types = testing::Types<double, fixproof::q16_16, fixproof::q16_16_trapping,
                                   fixproof::q16_16_i386, fixproof::q16_16_i8088_unrounded>;
#endif

/// One ulp of 16.16.
inline constexpr double ulp = 1.0 / 65536;

/// The error bound of a product: half an ulp if products round, one ulp if they truncate, and
/// almost nothing in double.
template <class N>
constexpr double product_error() {
  if constexpr (std::same_as<N, double>) {
    return 1e-12;
  } else {
    using fixproof::rounding;
    const rounding rule = N::rules.multiply;
    return rule == rounding::half_up || rule == rounding::half_away ? ulp / 2 : ulp;
  }
}

template <class N>
N number(double value) {
  return xsharp::Arithmetic<N>::constant(value, xsharp::Conversion::nearest);
}

template <class N>
xsharp::Vec3<N> vector(const xsharp::Triple& v) {
  return {number<N>(v[0]), number<N>(v[1]), number<N>(v[2])};
}

/// A vector of length 1, up to rounding.
template <class N>
xsharp::Vec3<N> direction(std::int64_t x, std::int64_t y, std::int64_t z) {
  const xsharp::Triple v{static_cast<double>(x), static_cast<double>(y),
                         static_cast<double>(z) + 0.5};
  return vector<N>(xsharp::scaled(v, 1 / xsharp::length(v)));
}

template <class N>
xsharp::Triple triple(const xsharp::Vec3<N>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace pipeline
