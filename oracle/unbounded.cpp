#include "oracle/unbounded.hpp"

#include <cstddef>
#include <stdexcept>

namespace oracle {
namespace {

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

Integer power_of_two(int exponent) { return Integer(1) << exponent; }

/// The largest integer not above numerator / denominator, for a positive denominator.
Integer floor_of(const Integer& numerator, const Integer& denominator) {
  const Integer toward_zero = numerator / denominator;
  return toward_zero * denominator > numerator ? toward_zero - 1 : toward_zero;
}

}  // namespace

Integer rounded(const Integer& numerator, const Integer& denominator, Rounding rule) {
  if (denominator == 0) throw std::domain_error("a ratio needs a denominator other than 0");
  const Integer n = denominator < 0 ? -numerator : numerator;
  const Integer d = abs(denominator);
  const int sign = n < 0 ? -1 : 1;
  switch (rule) {
    case Rounding::half_up:
      return floor_of(2 * n + d, 2 * d);
    case Rounding::half_away:
      return sign * floor_of(2 * abs(n) + d, 2 * d);
    case Rounding::half_even: {
      const Integer up = floor_of(2 * n + d, 2 * d);
      const bool tie = 2 * n + d == 2 * d * up;
      return tie && up % 2 != 0 ? up - 1 : up;
    }
    case Rounding::floor:
      return floor_of(n, d);
    case Rounding::truncate:
      return sign * floor_of(abs(n), d);
  }
  throw std::invalid_argument("no such rounding");
}

int word_bits(int fraction_bits) {
  require(fraction_bits >= 2 && fraction_bits <= 16, "fraction_bits must be 2 ... 16");
  return 2 * fraction_bits;
}

Integer one(int fraction_bits) { return power_of_two(word_bits(fraction_bits) / 2); }

Integer ulps(Word word, int fraction_bits) {
  const int bits = word_bits(fraction_bits);
  const Integer low = Integer(word) % power_of_two(bits);
  return low < power_of_two(bits - 1) ? low : low - power_of_two(bits);
}

Word wrap(const Integer& value, int bits) {
  require(bits >= 1 && bits <= 32, "bits must be 1 ... 32");
  const Integer modulus = power_of_two(bits);
  return static_cast<Word>(value - modulus * floor_of(value, modulus));
}

bool fits(const Integer& value, int bits) {
  require(bits >= 1 && bits <= 32, "bits must be 1 ... 32");
  const Integer limit = power_of_two(bits - 1);
  return -limit <= value && value < limit;
}

Word saturate(const Integer& value, int bits) {
  if (fits(value, bits)) return wrap(value, bits);
  const Integer limit = power_of_two(bits - 1);
  return wrap(value < 0 ? -limit : limit - 1, bits);
}

Integer exact_product(Word a, Word b, Rounding rule, int fraction_bits) {
  const Integer product = ulps(a, fraction_bits) * ulps(b, fraction_bits);
  return rounded(product, one(fraction_bits), rule);
}

std::optional<Integer> exact_quotient(Word n, Word d, Rounding rule, int fraction_bits) {
  const Integer divisor = ulps(d, fraction_bits);
  if (divisor == 0) return std::nullopt;
  return rounded(ulps(n, fraction_bits) * one(fraction_bits), divisor, rule);
}

Integer exact_mul_add(Word a, Word b, Word c, Rounding rule, int fraction_bits) {
  const Integer unit = one(fraction_bits);
  const Integer sum =
      ulps(a, fraction_bits) * ulps(b, fraction_bits) + ulps(c, fraction_bits) * unit;
  return rounded(sum, unit, rule);
}

Integer exact_dot(std::span<const Word> a, std::span<const Word> b, Rounding rule,
                  int fraction_bits) {
  require(a.size() == b.size(), "a dot product needs vectors of one length");
  Integer sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += ulps(a[i], fraction_bits) * ulps(b[i], fraction_bits);
  }
  return rounded(sum, one(fraction_bits), rule);
}

Integer exact_lerp(Word a, Word b, Word t, Rounding rule, int fraction_bits) {
  const Integer start = ulps(a, fraction_bits);
  const Integer unit = one(fraction_bits);
  const Integer sum = start * unit + (ulps(b, fraction_bits) - start) * ulps(t, fraction_bits);
  return rounded(sum, unit, rule);
}

}  // namespace oracle
