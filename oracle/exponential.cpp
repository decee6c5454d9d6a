#include "oracle/exponential.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <stdexcept>

#include "oracle/unbounded.hpp"

namespace oracle {
namespace {

using Decimal50 = boost::multiprecision::cpp_bin_float_50;

Integer above_all() { return Integer(1) << 64; }

Decimal50 value(Exponential function, const Decimal50& x) {
  static const Decimal50 log_2 = log(Decimal50(2));
  static const Decimal50 log_10 = log(Decimal50(10));
  switch (function) {
    case Exponential::exp2:
      return exp(x * log_2);
    case Exponential::exp:
      return exp(x);
    case Exponential::log2:
      return log(x) / log_2;
    case Exponential::log:
      return log(x);
    case Exponential::log10:
      return log(x) / log_10;
  }
  throw std::invalid_argument("no such function");
}

double library_value(Exponential function, double x) {
  switch (function) {
    case Exponential::exp2:
      return std::exp2(x);
    case Exponential::exp:
      return std::exp(x);
    case Exponential::log2:
      return std::log2(x);
    case Exponential::log:
      return std::log(x);
    case Exponential::log10:
      return std::log10(x);
  }
  throw std::invalid_argument("no such function");
}

/// 2^exponent ulps for a whole exponent.
Integer power_of_two(const Integer& exponent, Rounding ties) {
  if (exponent >= 64) return above_all();
  if (exponent < -64) return 0;
  if (exponent >= 0) return Integer(1) << static_cast<unsigned>(exponent);
  return rounded(1, Integer(1) << static_cast<unsigned>(-exponent), ties);
}

}  // namespace

std::optional<Integer> nearest(Exponential function, const Integer& ulps, int fraction_bits,
                               Rounding ties) {
  const bool is_power = function == Exponential::exp2 || function == Exponential::exp;
  const Integer unit = Integer(1) << fraction_bits;
  if (is_power) {
    if (ulps >= 64 * unit) return above_all();
    if (ulps <= -128 * unit) return 0;
    if (ulps == 0 || (function == Exponential::exp2 && ulps % unit == 0)) {
      return power_of_two(ulps / unit + fraction_bits, ties);
    }
  } else if (ulps <= 0) {
    return std::nullopt;
  }
  // Irrational, or the whole logarithm of a power: never a tie.
  const Decimal50 x = ldexp(Decimal50(ulps), -fraction_bits);
  const Decimal50 biased = ldexp(value(function, x), fraction_bits) + 0.5;
  if (biased >= Decimal50(above_all())) return above_all();
  const Decimal50 whole = floor(biased);
  const Decimal50 rest = biased - whole;
  constexpr double uncertain = 0x1p-90;
  if (rest < uncertain || 1 - rest < uncertain) {
    throw std::range_error("a result is too near a tie for 168 bits");
  }
  return Integer(whole);
}

std::optional<std::int64_t> fast::nearest(Exponential function, std::int64_t ulps,
                                          int fraction_bits, Rounding ties) {
  const double x = std::ldexp(static_cast<double>(ulps), -fraction_bits);
  const bool is_power = function == Exponential::exp2 || function == Exponential::exp;
  if (!is_power && ulps <= 0) return std::nullopt;
  const double scaled = std::ldexp(library_value(function, x), fraction_bits);
  constexpr double above_all_fast = 0x1p40;
  if (scaled >= above_all_fast) return std::int64_t{1} << 40;
  const double biased = scaled + 0.5;
  const double whole = std::floor(biased);
  const double rest = biased - whole;
  const double uncertain = (std::abs(scaled) + 1) * 0x1p-49;
  if (rest > uncertain && 1 - rest > uncertain) return static_cast<std::int64_t>(whole);
  const auto exact = oracle::nearest(function, ulps, fraction_bits, ties);
  return exact ? std::optional(static_cast<std::int64_t>(*exact)) : std::nullopt;
}

}  // namespace oracle
