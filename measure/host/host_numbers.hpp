/// @file
/// Numbers that are measured beside one another, and what a measurement asks of each. Those of
/// libraries are in files of their own.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>

#include "fixed/fixed.hpp"

namespace fixproof::measure {

/// 16.16 as it is written by hand: products rounded halves up, quotients cut toward zero. A
/// quotient that does not fit is anything, and a zero divisor ends the program.
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

/// How a number is made of a word and read in units of the last place, 2^-16; and its functions,
/// where it has them.
template <class N>
struct MeasuredNumber;

template <fixed::policy P>
struct MeasuredNumber<fixed::number<16, P>> {
  using N = fixed::number<16, P>;
  static N of_word(std::uint32_t word) { return N::from_raw(static_cast<std::int32_t>(word)); }
  static double in_units(N x) { return x.raw(); }
  static N root(N x) { return fixed::sqrt(x); }
  /// Of as many tenths of a degree as `x` has units.
  static N cosine(N x) { return fixed::cos<N>(x.raw()); }
  static N sine(N x) { return fixed::sin<N>(x.raw()); }
};

template <>
struct MeasuredNumber<PlainNumber> {
  static PlainNumber of_word(std::uint32_t word) { return {static_cast<std::int32_t>(word)}; }
  static double in_units(PlainNumber x) { return x.raw; }
};

/// A word that has more bits than the number is rounded to nearest.
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
  /// Of an angle of a unit, a tenth of a degree, in the number that is a unit.
  static constexpr F radians = static_cast<F>(0x1p16 * std::numbers::pi / 1800);
};

}  // namespace fixproof::measure
