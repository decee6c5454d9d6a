#include "oracle/decimal.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace oracle {
namespace {

/// @throws std::invalid_argument unless fraction_bits is 2 ... 16
void require_routine_format(int fraction_bits) { static_cast<void>(Format(fraction_bits)); }

}  // namespace

std::optional<Ratio> decimal_value(std::string_view text) {
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
  return Ratio{negative ? -digits : digits, scale};
}

std::optional<Ratio> double_value(double value) {
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
  return Ratio{numerator, denominator};
}

Integer to_ulps(const Ratio& value, Rounding rule, int fraction_bits) {
  return rounded(value.numerator << fraction_bits, value.denominator, rule);
}

std::optional<Integer> from_decimal(std::string_view text, Rounding rule, int fraction_bits) {
  require_routine_format(fraction_bits);
  const auto value = decimal_value(text);
  if (!value) return std::nullopt;
  return to_ulps(*value, rule, fraction_bits);
}

std::optional<Integer> from_double(double value, Rounding rule, int fraction_bits) {
  require_routine_format(fraction_bits);
  const auto ratio = double_value(value);
  if (!ratio) return std::nullopt;
  return to_ulps(*ratio, rule, fraction_bits);
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
