#include <cmath>

#include "oracle/function.hpp"
#include "oracle/real_function.hpp"

namespace oracle {
namespace {

/// A bound of the error of `value`, which the C library computed.
double error_of(Function function, double value) {
  constexpr double relative = 0x1p-49;
  switch (function) {
    case Function::sin_of_degrees:
    case Function::cos_of_degrees:
    case Function::tan_of_degrees:
    case Function::sin_of_turns:
    case Function::cos_of_turns:
    case Function::tan_of_turns:
      // Up to 2 pi radians, in doubles. The derivative is at most 1, or 1 + value^2.
      return (1 + value * value) * 4 * relative;
    default:
      return std::abs(value) * relative;
  }
}

}  // namespace

std::optional<std::int64_t> fast::nearest(Function function, std::int64_t x, std::int64_t y,
                                          int fraction_bits, Rounding ties) {
  if (!in_domain(function, x, y, fraction_bits)) return std::nullopt;
  // Products with powers of two are exact, and faster than std::ldexp().
  const auto one = static_cast<double>(std::int64_t{1} << fraction_bits);
  const double ulp = 1 / one;
  const auto real = [&](std::int64_t ulps) { return static_cast<double>(ulps) * ulp; };
  const double value = real_function(function, real(x), real(y));
  const double scaled = value * one;
  constexpr double above_all = 0x1p40;
  if (scaled >= above_all) return std::int64_t{1} << 40;
  if (scaled <= -above_all) return -(std::int64_t{1} << 40);
  const double biased = scaled + 0.5;
  const double whole = std::floor(biased);
  const double rest = biased - whole;
  const double uncertain = error_of(function, value) * one + (std::abs(scaled) + 1) * 0x1p-51;
  if (rest > uncertain && 1 - rest > uncertain) return static_cast<std::int64_t>(whole);
  const auto exact = oracle::nearest(function, x, y, fraction_bits, ties);
  if (!exact) return std::nullopt;
  const Integer limit = Integer(1) << 40;
  return static_cast<std::int64_t>(*exact > limit ? limit : *exact < -limit ? -limit : *exact);
}

}  // namespace oracle
