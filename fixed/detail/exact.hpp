/// @file
/// Results of operations on stored integers before they are narrowed to the range.
#pragma once

#include <utility>

#include "fixed/detail/inlining.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// Holds the sum, the difference or the negative of stored integers.
template <class Raw>
using sum_t = signed_t<signed_bits<Raw> + 1>;

template <class Raw>
FIXED_ALWAYS_INLINE constexpr sum_t<Raw> exact_sum(Raw a, Raw b) noexcept {
  return sum_t<Raw>{a} + sum_t<Raw>{b};
}

template <class Raw>
FIXED_ALWAYS_INLINE constexpr sum_t<Raw> exact_difference(Raw a, Raw b) noexcept {
  return sum_t<Raw>{a} - sum_t<Raw>{b};
}

template <class Raw>
FIXED_ALWAYS_INLINE constexpr sum_t<Raw> exact_negative(Raw a) noexcept {
  return -sum_t<Raw>{a};
}

template <class Raw>
constexpr sum_t<Raw> exact_magnitude(Raw a) noexcept {
  return a < 0 ? -sum_t<Raw>{a} : sum_t<Raw>{a};
}

/// a * b rounded by rule Rounding to an integer number of ulps.
template <int FractionBits, rounding Rounding, class Raw>
FIXED_ALWAYS_INLINE constexpr product_t<Raw> rounded_product(Raw a, Raw b) noexcept {
  using wide = product_t<Raw>;
  return shift_right<Rounding>(wide{a} * wide{b}, FractionBits);
}

/// a * b + c rounded by rule Rounding to an integer number of ulps.
template <int FractionBits, rounding Rounding, class Raw>
constexpr mul_add_t<Raw, FractionBits> rounded_mul_add(Raw a, Raw b, Raw c) noexcept {
  using wide = mul_add_t<Raw, FractionBits>;
  const wide sum = wide{a} * wide{b} + wide{c} * (wide{1} << FractionBits);
  return shift_right<Rounding>(sum, FractionBits);
}

/// Places as an int. Those beyond its range become 64 or -64, which shift all bits out.
template <integer Int>
constexpr int places_of(Int places) noexcept {
  return std::in_range<int>(places) ? static_cast<int>(places) : places > 0 ? 64 : -64;
}

/// a * 2^places, toward -infinity. More places than the width of Raw count as its width, for which
/// every result of a left shift except 0 is out of range.
template <class Raw>
constexpr auto exact_shift_left(Raw a, int places) noexcept {
  using wide = signed_t<signed_bits<Raw> + bits_of<Raw>>;
  constexpr int most = bits_of<Raw>;
  if (places < 0) return wide{a} >> (places < -most ? most : -places);
  return wide{a} << (places < most ? places : most);
}

}  // namespace fixproof::detail
