/// @file
/// Adapters for the measured number types. Those of libraries have their own files.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>

#include "fixed/fixed.hpp"

namespace fixproof::measure {

/// Hand-written 16.16: products round half up, quotients truncate. A quotient that does not fit is
/// unspecified, and a zero divisor ends the program.
struct PlainNumber {
  std::int32_t raw = 0;

  friend PlainNumber operator+(PlainNumber a, PlainNumber b) {
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(a.raw) +
                                      static_cast<std::uint32_t>(b.raw))};
  }
  friend PlainNumber operator*(PlainNumber a, PlainNumber b) {
    return {static_cast<std::int32_t>((std::int64_t{a.raw} * b.raw + 0x8000) >> 16)};
  }
  friend PlainNumber operator/(PlainNumber n, PlainNumber d) {
    return {static_cast<std::int32_t>((std::int64_t{n.raw} << 16) / d.raw)};
  }
};

/// Converts words to numbers and numbers to ulps (2^-16), and names the functions that the number
/// has.
template <class N>
struct MeasuredNumber;

template <fixproof::policy P>
struct MeasuredNumber<fixproof::number<std::int32_t, 16, P>> {
  using N = fixproof::number<std::int32_t, 16, P>;
  static N of_word(std::uint32_t word) { return N::from_raw(static_cast<std::int32_t>(word)); }
  static double in_units(N x) { return x.raw(); }
  static N root(N x) { return fixproof::sqrt(x); }
  /// The cosine of as many tenths of a degree as `x` has units.
  static N cosine(N x) { return fixproof::cos_of_tenths<N>(x.raw()); }
  static N sine(N x) { return fixproof::sin_of_tenths<N>(x.raw()); }
  static N sine_of_radians(N x) { return fixproof::sin(x); }
};

template <>
struct MeasuredNumber<PlainNumber> {
  static PlainNumber of_word(std::uint32_t word) { return {static_cast<std::int32_t>(word)}; }
  static double in_units(PlainNumber x) { return x.raw; }
};

/// Words with more bits than the number's significand round to nearest.
template <std::floating_point F>
struct MeasuredNumber<F> {
  static F of_word(std::uint32_t word) {
    return static_cast<F>(static_cast<std::int32_t>(word)) * F{0x1p-16};
  }
  static double in_units(F x) { return static_cast<double>(x) * 0x1p16; }
  static F root(F x) { return std::sqrt(x); }
  static F cosine(F x) { return std::cos(x * radians); }
  static F sine(F x) { return std::sin(x * radians); }
  static F sine_of_radians(F x) { return std::sin(x); }

 private:
  /// Converts tenths of a degree, stored as units of 2^-16, to radians.
  static constexpr F radians = static_cast<F>(0x1p16 * std::numbers::pi / 1800);
};

}  // namespace fixproof::measure
