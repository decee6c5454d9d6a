#include "oracle/format.hpp"

#include <cstddef>
#include <stdexcept>

namespace oracle {
namespace {

void require_valid(const Format& format) {
  if (format.bits < 1 || format.bits > 64) throw std::invalid_argument("a word has 1 to 64 bits");
}

/// 0 <= exponent <= 64.
template <class Int>
Int power_of_two(int exponent) {
  // Built-in integers are faster, and nearly all words have at most 32 bits.
  return exponent < 63 ? Int(std::int64_t{1} << exponent) : Int(1) << exponent;
}

/// The largest integer not above numerator / denominator, for a positive denominator.
template <class Int>
Int floor_of(const Int& numerator, const Int& denominator) {
  const Int toward_zero = numerator / denominator;
  return toward_zero * denominator > numerator ? toward_zero - 1 : toward_zero;
}

template <class Int>
Int least(const Format& format) {
  require_valid(format);
  return format.is_signed ? Int(-power_of_two<Int>(format.bits - 1)) : Int(0);
}

template <class Int>
Int most(const Format& format) {
  require_valid(format);
  return power_of_two<Int>(format.is_signed ? format.bits - 1 : format.bits) - 1;
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
    case Rounding::ceiling:
      return -floor_of<Int>(-n, d);
  }
  throw std::invalid_argument("no such rounding");
}

template <class Int>
Int one(const Format& format) {
  require_valid(format);
  if (format.fraction_bits < 0 || format.fraction_bits > format.bits)
    throw std::invalid_argument("fraction_bits must be 0 ... bits");
  return power_of_two<Int>(format.fraction_bits);
}

template <class Int>
Int ulps(LongWord word, const Format& format) {
  require_valid(format);
  const LongWord low = word & ~LongWord{0} >> (64 - format.bits);
  const bool is_negative = format.is_signed && low >> (format.bits - 1) != 0;
  return is_negative ? Int(low) - power_of_two<Int>(format.bits) : Int(low);
}

Integer lowest(const Format& format) { return least<Integer>(format); }
Integer highest(const Format& format) { return most<Integer>(format); }

template <class Int>
bool fits(const std::type_identity_t<Int>& value, const Format& format) {
  return least<Int>(format) <= value && value <= most<Int>(format);
}

template <class Int>
LongWord wrap(const std::type_identity_t<Int>& value, const Format& format) {
  require_valid(format);
  const Int modulus = power_of_two<Int>(format.bits);
  // The remainder of a negative dividend is not positive.
  const Int remainder = value % modulus;
  return static_cast<LongWord>(remainder < 0 ? remainder + modulus : remainder);
}

LongWord saturate(const Integer& value, const Format& format) {
  if (fits(value, format)) return wrap(value, format);
  return wrap(value < 0 ? lowest(format) : highest(format), format);
}

template <class Int>
Int exact_product(LongWord a, LongWord b, Rounding rule, const Format& format) {
  return rounded<Int>(ulps<Int>(a, format) * ulps<Int>(b, format), one<Int>(format), rule);
}

template <class Int>
std::optional<Int> exact_quotient(LongWord n, LongWord d, Rounding rule, const Format& format) {
  const Int divisor = ulps<Int>(d, format);
  if (divisor == 0) return std::nullopt;
  return rounded<Int>(ulps<Int>(n, format) * one<Int>(format), divisor, rule);
}

template <class Int>
std::optional<Int> exact_root(LongWord x, Rounding rule, const Format& format) {
  const Int value = ulps<Int>(x, format);
  if (value < 0) return std::nullopt;
  // sqrt(value / one) * one, in ulps, is the root of value * one.
  const Int radicand = value * one<Int>(format);
  Int rest;
  const Int floor = boost::multiprecision::sqrt(radicand, rest);
  if (rule == Rounding::floor || rule == Rounding::truncate) return floor;
  if (rule == Rounding::ceiling) return rest > 0 ? floor + 1 : floor;
  // The rest is radicand - floor^2; above the midpoint it exceeds floor + 1/4.
  return rest > floor ? floor + 1 : floor;
}

Integer exact_mul_add(LongWord a, LongWord b, LongWord c, Rounding rule, const Format& format) {
  const Integer sum = ulps(a, format) * ulps(b, format) + ulps(c, format) * one(format);
  return rounded(sum, one(format), rule);
}

Integer exact_dot(std::span<const Word> a, std::span<const Word> b, Rounding rule,
                  const Format& format) {
  if (a.size() != b.size())
    throw std::invalid_argument("a dot product needs vectors of one length");
  Integer sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += ulps(a[i], format) * ulps(b[i], format);
  return rounded(sum, one(format), rule);
}

Integer exact_lerp(LongWord a, LongWord b, LongWord t, Rounding rule, const Format& format) {
  const Integer start = ulps(a, format);
  const Integer sum = start * one(format) + (ulps(b, format) - start) * ulps(t, format);
  return rounded(sum, one(format), rule);
}

Integer converted(const Integer& value, const Format& from, const Format& to, Rounding rule) {
  return rounded(value * one(to), one(from), rule);
}

template Integer rounded<Integer>(const Integer&, const Integer&, Rounding);
template Wide rounded<Wide>(const Wide&, const Wide&, Rounding);
template Integer one<Integer>(const Format&);
template Wide one<Wide>(const Format&);
template Integer ulps<Integer>(LongWord, const Format&);
template Wide ulps<Wide>(LongWord, const Format&);
template LongWord wrap<Integer>(const Integer&, const Format&);
template LongWord wrap<Wide>(const Wide&, const Format&);
template bool fits<Integer>(const Integer&, const Format&);
template bool fits<Wide>(const Wide&, const Format&);
template Integer exact_product<Integer>(LongWord, LongWord, Rounding, const Format&);
template Wide exact_product<Wide>(LongWord, LongWord, Rounding, const Format&);
template std::optional<Integer> exact_quotient<Integer>(LongWord, LongWord, Rounding,
                                                        const Format&);
template std::optional<Wide> exact_quotient<Wide>(LongWord, LongWord, Rounding, const Format&);
template std::optional<Integer> exact_root<Integer>(LongWord, Rounding, const Format&);
template std::optional<Wide> exact_root<Wide>(LongWord, Rounding, const Format&);

}  // namespace oracle
