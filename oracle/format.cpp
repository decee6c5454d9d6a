#include "oracle/format.hpp"

#include <stdexcept>

#include "oracle/unbounded.hpp"

namespace oracle {
namespace {

void require_valid(const Format& format) {
  if (format.bits < 1 || format.bits > 64) throw std::invalid_argument("a word has 1 to 64 bits");
  if (format.fraction_bits < 0 || format.fraction_bits > format.bits)
    throw std::invalid_argument("fraction_bits must be 0 ... bits");
}

/// 1.0 in ulps.
Integer scale(const Format& format) { return Integer(1) << format.fraction_bits; }

}  // namespace

Integer lowest(const Format& format) {
  require_valid(format);
  return format.is_signed ? -(Integer(1) << (format.bits - 1)) : Integer(0);
}

Integer highest(const Format& format) {
  require_valid(format);
  return (Integer(1) << (format.is_signed ? format.bits - 1 : format.bits)) - 1;
}

bool fits(const Integer& value, const Format& format) {
  return lowest(format) <= value && value <= highest(format);
}

Integer ulps(LongWord word, const Format& format) {
  const Integer modulus = Integer(1) << format.bits;
  const Integer low = Integer(word) % modulus;
  return low > highest(format) ? low - modulus : low;
}

LongWord wrap(const Integer& value, const Format& format) {
  require_valid(format);
  const Integer modulus = Integer(1) << format.bits;
  // The remainder of a negative dividend is not positive.
  const Integer remainder = value % modulus;
  return static_cast<LongWord>(remainder < 0 ? remainder + modulus : remainder);
}

LongWord saturate(const Integer& value, const Format& format) {
  if (fits(value, format)) return wrap(value, format);
  return wrap(value < 0 ? lowest(format) : highest(format), format);
}

Integer exact_product(LongWord a, LongWord b, Rounding rule, const Format& format) {
  return rounded(ulps(a, format) * ulps(b, format), scale(format), rule);
}

std::optional<Integer> exact_quotient(LongWord n, LongWord d, Rounding rule, const Format& format) {
  const Integer divisor = ulps(d, format);
  if (divisor == 0) return std::nullopt;
  return rounded(ulps(n, format) * scale(format), divisor, rule);
}

std::optional<Integer> exact_root(LongWord x, Rounding rule, const Format& format) {
  const Integer value = ulps(x, format);
  if (value < 0) return std::nullopt;
  const Integer radicand = value * scale(format);
  Integer rest;
  const Integer floor = boost::multiprecision::sqrt(radicand, rest);
  if (rule == Rounding::floor || rule == Rounding::truncate) return floor;
  // The rest is radicand - floor^2; above the midpoint it exceeds floor + 1/4.
  return rest > floor ? floor + 1 : floor;
}

Integer converted(const Integer& value, const Format& from, const Format& to, Rounding rule) {
  require_valid(from);
  return rounded(value * scale(to), scale(from), rule);
}

}  // namespace oracle
