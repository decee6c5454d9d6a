/// @file
/// The functions of real numbers as intervals: four series, and what is composed of them.
///
/// A series ends at a term below the last digit of its sum. What is left out is less than that
/// term, because each term is at most half of the one before or alternates with it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/function_kinds.hpp"
#include "fixed/detail/interval.hpp"
#include "fixed/detail/interval_constants.hpp"

namespace fixproof::detail {

/// A small integer, exactly, with as many digits as `like`.
constexpr interval whole_like(const interval& like, std::uint64_t n) noexcept {
  return {like.size(), false, n, 0};
}

/// Whether a term is too small for the digits of a sum, or nothing is known about it.
constexpr bool is_last(const interval& term, const interval& sum) noexcept {
  return term.is_zero() || term.exponent() > 1 ||
         term.exponent() + 1 < sum.exponent() - 32 * static_cast<int>(sum.size());
}

/// e^x with n digits, for |x| < 1.
constexpr interval small_exponential(const interval& x, std::size_t n) noexcept {
  // Of so small a part the series is short, and as many squares make it the whole.
  const int squares = static_cast<int>(n) + 2;
  const interval part = x.scaled(-squares);
  interval term(n, false, 1, 0);
  interval sum = term;
  for (std::uint32_t k = 1; !is_last(term, sum); ++k) {
    term = term * part / k;
    sum = sum + term;
  }
  sum = sum.widened();
  for (int i = 0; i < squares; ++i) sum = sum * sum;
  return sum;
}

/// 2^x. @pre |x| < 2^20
constexpr interval power_of_two(const interval& x) noexcept {
  const auto whole = static_cast<int>(x.nearest_integer());
  const interval integer(x.size(), x.is_negative(), static_cast<std::uint64_t>(whole), 0);
  const interval rest = (x - integer) * interval(x.size(), log_of_2);
  return small_exponential(rest, x.size()).scaled(x.is_negative() ? -whole : whole);
}

/// x + x^3 / 3 + x^5 / 5 + ..., or with signs that alternate. @pre |x| <= 1/16
constexpr interval odd_series(const interval& x, bool alternates) noexcept {
  const interval square = alternates ? -(x * x) : x * x;
  interval power = x;
  interval sum = x;
  for (std::uint32_t n = 3; !is_last(power, sum); n += 2) {
    power = power * square;
    sum = sum + power / n;
  }
  return sum.widened();
}

/// A logarithm as a multiple of that of 2, and the natural logarithm of the rest.
struct split_logarithm {
  interval twos;
  interval rest;
};

/// The logarithm of a positive number.
constexpr split_logarithm logarithm_of(const interval& x) noexcept {
  const std::size_t n = x.size();
  // x = m 2^exponent with 11/16 <= m < 11/8, and m is next to an eighth.
  const bool is_low = x.first_digit() >> 28 < 11;
  const int exponent = x.exponent() - (is_low ? 1 : 0);
  const interval m = x.scaled(-exponent);
  const std::uint32_t eighths = ((x.first_digit() >> (is_low ? 27 : 28)) + 1) / 2;
  // If the first bit is not known, the quotient is unknown, too.
  const interval center(n, false, x.is_normal() ? eighths : 0, 3);
  const interval sum = x.is_normal() ? m + center : m;
  const interval z = (m - center) / sum;
  interval rest = odd_series(z, false).scaled(1);
  if (x.is_normal() && eighths != 8) {
    const std::size_t index = eighths < 8 ? eighths - 6 : eighths - 7;
    rest = rest + interval(n, logs_of_eighths[index]);
  }
  const auto twos = static_cast<std::uint64_t>(exponent < 0 ? -exponent : exponent);
  return {interval(n, exponent < 0, twos, 0), rest};
}

constexpr interval natural_logarithm(const interval& x) noexcept {
  const split_logarithm log = logarithm_of(x);
  return log.twos * interval(x.size(), log_of_2) + log.rest;
}

constexpr interval binary_logarithm(const interval& x) noexcept {
  const split_logarithm log = logarithm_of(x);
  return log.twos + log.rest * interval(x.size(), log2_of_e);
}

/// The cosine and the sine of an angle.
struct interval_cos_sin {
  interval cos;
  interval sin;
};

/// The cosine with n digits, and the sine. @pre |x| <= 0.8
constexpr interval_cos_sin cos_sin_of(const interval& x, std::size_t n) noexcept {
  const interval square = -(x * x);
  interval term(n, false, 1, 0);
  interval cos = term;
  for (std::uint32_t k = 1; !is_last(term, cos); k += 2) {
    term = term * square / (k * (k + 1));
    cos = cos + term;
  }
  term = x;
  interval sin = x;
  for (std::uint32_t k = 2; !is_last(term, sin); k += 2) {
    term = term * square / (k * (k + 1));
    sin = sin + term;
  }
  return {cos.widened(), sin.widened()};
}

/// atan(x) for 0 <= x <= 1.
constexpr interval arctangent(const interval& x) noexcept {
  const std::size_t n = x.size();
  if (x.exponent() > 1) return x;  // nothing is known about it
  // x - i / 8 is at most 1/16, and a little more if the first bit is not known.
  const auto eighths = static_cast<std::uint32_t>(x.scaled(3).nearest_integer());
  if (eighths == 0) return odd_series(x, true);
  const interval center(n, false, eighths, 3);
  const interval part = (x - center) / (whole_like(x, 1) + x * center);
  return odd_series(part, true) + interval(n, arctangents_of_eighths[eighths - 1]);
}

/// The angle of the vector (x, y) in radians, from 0 to pi. @pre y >= 0, and not both are 0
constexpr interval angle_of_vector(const interval& y, const interval& x) noexcept {
  const std::size_t n = y.size();
  const interval width = x.magnitude();
  const interval difference = width - y;
  const bool is_steep = difference.is_negative();
  interval angle = is_steep ? arctangent(width / y) : arctangent(y / width);
  if (is_steep) angle = interval(n, real_half_pi) - angle;
  if (x.is_negative()) angle = interval(n, real_half_pi).scaled(1) - angle;
  return angle;
}

}  // namespace fixproof::detail
