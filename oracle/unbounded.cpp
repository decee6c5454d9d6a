#include "oracle/unbounded.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace oracle {
namespace {

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(message);
}

/// For an exponent of 0 ... 62; the bits of a word are at most 32.
std::int64_t power_of_two(int exponent) { return std::int64_t{1} << exponent; }

/// The largest integer not above numerator / denominator, for a positive denominator.
template <class Int>
Int floor_of(const Int& numerator, const Int& denominator) {
  const Int toward_zero = numerator / denominator;
  return toward_zero * denominator > numerator ? toward_zero - 1 : toward_zero;
}

}  // namespace

template <class Int>
Int rounded(const std::type_identity_t<Int>& numerator,
            const std::type_identity_t<Int>& denominator, Rounding rule) {
  if (denominator == 0) throw std::domain_error("a ratio needs a denominator other than 0");
  const Int n = denominator < 0 ? -numerator : numerator;
  const Int d = abs(denominator);
  const int sign = n < 0 ? -1 : 1;
  switch (rule) {
    case Rounding::half_up:
      return floor_of<Int>(2 * n + d, 2 * d);
    case Rounding::half_away:
      return sign * floor_of<Int>(2 * abs(n) + d, 2 * d);
    case Rounding::half_even: {
      const Int up = floor_of<Int>(2 * n + d, 2 * d);
      const bool tie = 2 * n + d == 2 * d * up;
      return tie && up % 2 != 0 ? up - 1 : up;
    }
    case Rounding::floor:
      return floor_of<Int>(n, d);
    case Rounding::truncate:
      return sign * floor_of<Int>(abs(n), d);
  }
  throw std::invalid_argument("no such rounding");
}

int word_bits(int fraction_bits) {
  require(fraction_bits >= 2 && fraction_bits <= 16, "fraction_bits must be 2 ... 16");
  return 2 * fraction_bits;
}

template <class Int>
Int one(int fraction_bits) {
  return power_of_two(word_bits(fraction_bits) / 2);
}

template <class Int>
Int ulps(Word word, int fraction_bits) {
  const int bits = word_bits(fraction_bits);
  const std::int64_t low = word % power_of_two(bits);
  return low < power_of_two(bits - 1) ? low : low - power_of_two(bits);
}

template <class Int>
Word wrap(const std::type_identity_t<Int>& value, int bits) {
  require(bits >= 1 && bits <= 32, "bits must be 1 ... 32");
  const Int modulus = power_of_two(bits);
  return static_cast<Word>(value - modulus * floor_of<Int>(value, modulus));
}

template <class Int>
bool fits(const std::type_identity_t<Int>& value, int bits) {
  require(bits >= 1 && bits <= 32, "bits must be 1 ... 32");
  const Int limit = power_of_two(bits - 1);
  return -limit <= value && value < limit;
}

Word saturate(const Integer& value, int bits) {
  if (fits(value, bits)) return wrap(value, bits);
  const Integer limit = power_of_two(bits - 1);
  return wrap(value < 0 ? -limit : limit - 1, bits);
}

template <class Int>
Int exact_product(Word a, Word b, Rounding rule, int fraction_bits) {
  const Int product = ulps<Int>(a, fraction_bits) * ulps<Int>(b, fraction_bits);
  return rounded<Int>(product, one<Int>(fraction_bits), rule);
}

template <class Int>
std::optional<Int> exact_quotient(Word n, Word d, Rounding rule, int fraction_bits) {
  const Int divisor = ulps<Int>(d, fraction_bits);
  if (divisor == 0) return std::nullopt;
  return rounded<Int>(ulps<Int>(n, fraction_bits) * one<Int>(fraction_bits), divisor, rule);
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

template Integer rounded<Integer>(const Integer&, const Integer&, Rounding);
template Wide rounded<Wide>(const Wide&, const Wide&, Rounding);
template Integer one<Integer>(int);
template Wide one<Wide>(int);
template Integer ulps<Integer>(Word, int);
template Wide ulps<Wide>(Word, int);
template Word wrap<Integer>(const Integer&, int);
template Word wrap<Wide>(const Wide&, int);
template bool fits<Integer>(const Integer&, int);
template bool fits<Wide>(const Wide&, int);
template Integer exact_product<Integer>(Word, Word, Rounding, int);
template Wide exact_product<Wide>(Word, Word, Rounding, int);
template std::optional<Integer> exact_quotient<Integer>(Word, Word, Rounding, int);
template std::optional<Wide> exact_quotient<Wide>(Word, Word, Rounding, int);

}  // namespace oracle
