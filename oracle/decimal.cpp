#include "oracle/decimal.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace oracle {

std::optional<Integer> from_decimal(std::string_view text, Rounding rule, int fraction_bits) {
  const Integer unit = one(fraction_bits);
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);

  Integer digits = 0;
  Integer scale = 1;
  bool any_digit = false;
  bool after_point = false;
  for (const char c : text) {
    if (c == '.' && !after_point) {
      after_point = true;
    } else if (c >= '0' && c <= '9') {
      digits = digits * 10 + (c - '0');
      if (after_point) scale *= 10;
      any_digit = true;
    } else {
      return std::nullopt;
    }
  }
  if (!any_digit) return std::nullopt;
  return rounded((negative ? -digits : digits) * unit, scale, rule);
}

std::optional<Integer> from_double(double value, Rounding rule, int fraction_bits) {
  const Integer unit = one(fraction_bits);
  if (!std::isfinite(value)) return std::nullopt;
  // value = significand * 2^exponent with a whole significand.
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  constexpr int kDigits = std::numeric_limits<double>::digits;
  Integer numerator = static_cast<std::int64_t>(std::ldexp(fraction, kDigits));
  Integer denominator = 1;
  exponent -= kDigits;
  if (exponent > 0) numerator <<= exponent;
  if (exponent < 0) denominator <<= -exponent;
  return rounded(numerator * unit, denominator, rule);
}

std::string to_decimal(Word word, int fraction_bits) {
  const Integer unit = one(fraction_bits);
  const Integer value = ulps(word, fraction_bits);
  const Integer magnitude = abs(value);
  std::string text = value < 0 ? "-" : "";
  text += std::to_string(static_cast<Word>(magnitude / unit));
  Integer fraction = magnitude % unit;
  if (fraction != 0) text += '.';
  while (fraction != 0) {
    fraction *= 10;
    text += static_cast<char>('0' + static_cast<int>(fraction / unit));
    fraction %= unit;
  }
  return text;
}

}  // namespace oracle
