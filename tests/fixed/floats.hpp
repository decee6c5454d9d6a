/// @file
/// Floating-point numbers taken apart, and the numbers that they should become.
#pragma once

#include <bit>
#include <cstdint>

#include "tests/fixed/exact.hpp"

namespace floats {

/// Significand and exponent of a finite float or double: value = m 2^e.
struct parts {
  std::int64_t m;
  int e;
};

inline parts take_apart(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
  auto m = static_cast<std::int64_t>(bits & 0xfffffffffffff);
  if (biased != 0) m += 0x10000000000000;
  return {bits >> 63 != 0 ? -m : m, (biased == 0 ? 1 : biased) - 1075};
}

inline parts take_apart(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  const auto biased = static_cast<int>(bits >> 23 & 0xff);
  auto m = static_cast<std::int64_t>(bits & 0x7fffff);
  if (biased != 0) m += 0x800000;
  return {bits >> 31 != 0 ? -m : m, (biased == 0 ? 1 : biased) - 150};
}

/// The expected number for a finite floating-point value.
template <class Number, class Float>
exact::outcome<Number> converted(Float x) {
  const auto [m, e] = take_apart(x);
  const int scale = e + Number::fraction_bits;
  if (scale <= 0) {
    // Below 2^-70 only the sign matters.
    return exact::result<Number>({m, exact::integer{1} << (scale < -70 ? 70 : -scale)});
  }
  if (scale <= 64) return exact::in_range<Number>(exact::integer{m} << scale);
  // This is a multiple of every range, so it wraps to 0.
  const exact::integer sign = m < 0 ? -1 : m > 0 ? 1 : 0;
  return exact::in_range<Number>(sign * (exact::integer{1} << 100));
}

}  // namespace floats
