/// @file
/// Checks each result against its documented rounding, by the oracle's rules in built-in integers.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <numbers>

#include "measure/host/host_loop.hpp"
#include "oracle/exact.hpp"
#include "oracle/fast.hpp"

namespace fixproof::measure {

enum class HostJudgement {
  right,
  exception,  ///< breaks the rule within the known error of the contender
  wrong,
};

/// Converts a whole number of units to a word.
inline std::uint32_t word_of_units(double units) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(units));
}

inline HostJudgement judged(bool right) {
  return right ? HostJudgement::right : HostJudgement::wrong;
}

inline HostJudgement is_word(double result, std::uint64_t word) {
  return judged(result == static_cast<std::int32_t>(word));
}

template <oracle::Rounding R>
HostJudgement product_rounded(const HostCase& c) {
  return is_word(c.result, oracle::fast::mul(word_of_units(c.operands[0]),
                                             word_of_units(c.operands[1]), R, 16));
}

template <oracle::Rounding R>
HostJudgement quotient_rounded(const HostCase& c) {
  const auto q =
      oracle::fast::quotient(word_of_units(c.operands[0]), word_of_units(c.operands[1]), R, 16);
  return q ? is_word(c.result, *q) : HostJudgement::wrong;
}

template <oracle::DivideRule R>
HostJudgement quotient_of_fixed_asm(const HostCase& c) {
  const auto q =
      oracle::fast::div(word_of_units(c.operands[0]), word_of_units(c.operands[1]), R, 16);
  return q ? is_word(c.result, *q) : HostJudgement::wrong;
}

inline HostJudgement root_rounded(const HostCase& c) {
  const auto root =
      oracle::fast::exact_root(word_of_units(c.operands[0]), oracle::Rounding::half_up, 16);
  return root ? is_word(c.result, *root) : HostJudgement::wrong;
}

/// The cosine of a whole number of tenths of a degree.
inline HostJudgement cosine_rounded(const HostCase& c) {
  return is_word(c.result, oracle::cos_sin(static_cast<std::int16_t>(c.operands[0])).cos);
}

template <oracle::Rounding R>
HostJudgement coordinate_rounded(const HostCase& c) {
  std::uint32_t sum = word_of_units(c.operands[3]);
  for (std::size_t k = 0; k < 3; ++k) {
    sum += static_cast<std::uint32_t>(
        oracle::fast::mul(word_of_units(c.operands[k]), word_of_units(c.operands[4 + k]), R, 16));
  }
  return is_word(c.result, sum);
}

/// Half the spacing of F at `x`: the largest error of one rounding to nearest. fma() makes the
/// residuals compared with it exact.
template <std::floating_point F>
double half_step(double x) {
  return x == 0 ? 0 : std::ldexp(0.5, std::ilogb(x) + 1 - std::numeric_limits<F>::digits);
}

template <std::floating_point F>
HostJudgement product_in(const HostCase& c) {
  const double r = c.result * 0x1p16;
  return judged(std::fabs(std::fma(c.operands[0], c.operands[1], -r)) <= half_step<F>(r));
}

template <std::floating_point F>
HostJudgement quotient_in(const HostCase& c) {
  const double residual = std::fma(c.result, c.operands[1], -c.operands[0] * 0x1p16);
  return judged(std::fabs(residual) <= half_step<F>(c.result) * std::fabs(c.operands[1]));
}

/// The error of r^2 is 2 r times the error of r.
template <std::floating_point F>
HostJudgement root_in(const HostCase& c) {
  const double r = c.result;
  const double residual = std::fma(r, r, -c.operands[0] * 0x1p16);
  return judged(r >= 0 && std::fabs(residual) <= 2 * r * half_step<F>(r));
}

/// Judges double itself in higher precision.
inline long double wide(double x) { return static_cast<long double>(x); }

/// The angle in radians, at most 6.3, is rounded twice, and the cosine once.
template <std::floating_point F>
HostJudgement cosine_in(const HostCase& c) {
  constexpr long double radians = std::numbers::pi_v<long double> / 1800;
  const long double exact = std::cos(wide(c.operands[0]) * radians) * 65536;
  constexpr auto tolerance = 16 * static_cast<long double>(std::numeric_limits<F>::epsilon());
  return judged(std::fabs(wide(c.result) - exact) <= tolerance * 65536);
}

/// Each term is rounded at most four times, in a product and three sums, by half an epsilon.
template <std::floating_point F>
HostJudgement coordinate_in(const HostCase& c) {
  long double exact = wide(c.operands[3]);
  long double magnitude = std::fabs(exact);
  for (std::size_t k = 0; k < 3; ++k) {
    const long double product = wide(c.operands[k]) * wide(c.operands[4 + k]) / 65536;
    exact += product;
    magnitude += std::fabs(product);
  }
  constexpr auto share = 2.01L * static_cast<long double>(std::numeric_limits<F>::epsilon());
  return judged(std::fabs(wide(c.result) - exact) <= share * magnitude);
}

}  // namespace fixproof::measure
