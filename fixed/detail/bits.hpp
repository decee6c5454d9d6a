/// @file
/// The zeros at the ends of a word.
///
/// In code for a GPU, nvcc takes std::countr_zero of every word as its width, and std::countl_zero
/// of every word of 64 bits, because libstdc++ calls builtins that nvcc has for the processor
/// alone.
#pragma once

#include <bit>
#include <concepts>
#include <limits>

#include "fixed/detail/gpu.hpp"

namespace fixproof::detail {

/// The zeros above the highest one.
template <std::unsigned_integral Word>
constexpr int leading_zeros(Word x) noexcept {
#if defined(FIXED_GPU) && defined(__NVCC__)
  constexpr int above =
      std::numeric_limits<unsigned long long>::digits - std::numeric_limits<Word>::digits;
  return __builtin_clzll(x) - above;
#else
  return std::countl_zero(x);
#endif
}

/// The zeros below the lowest one.
template <std::unsigned_integral Word>
constexpr int trailing_zeros(Word x) noexcept {
#if defined(FIXED_GPU) && defined(__NVCC__)
  constexpr int digits = std::numeric_limits<Word>::digits;
  return x == 0 ? digits : digits - 1 - leading_zeros(static_cast<Word>(x & (Word{0} - x)));
#else
  return std::countr_zero(x);
#endif
}

/// The bits up to the highest one.
template <std::unsigned_integral Word>
constexpr int width_of(Word x) noexcept {
  return std::numeric_limits<Word>::digits - leading_zeros(x);
}

}  // namespace fixproof::detail
