#include "oracle/exact.hpp"

#include <stdexcept>

#include "oracle/unbounded.hpp"

namespace oracle {
namespace {

/// The 386 divides the magnitudes as unsigned integers and ignores the sign bit, so only a quotient
/// too wide for an unsigned word faults, before rounding.
std::optional<Word> i386_rounded(Word n, Word d, int fraction_bits) {
  const auto truncated = exact_quotient<Wide>(n, d, Rounding::truncate, fraction_bits);
  if (!truncated || abs(*truncated) >= Wide(1) << word_bits(fraction_bits)) return std::nullopt;
  return quotient(n, d, Rounding::half_away, fraction_bits);
}

std::optional<Word> i386_unrounded(Word n, Word d, int fraction_bits) {
  const auto truncated = exact_quotient<Wide>(n, d, Rounding::truncate, fraction_bits);
  if (!truncated || !fits<Wide>(*truncated, word_bits(fraction_bits))) return std::nullopt;
  return wrap<Wide>(*truncated, word_bits(fraction_bits));
}

/// The 8088 divides by the whole part of the divisor's magnitude, so the quotient has the scale of
/// n.
std::optional<Word> i8088(Word n, Word d, Rounding rule, int fraction_bits) {
  const Wide units =
      rounded<Wide>(ulps<Wide>(d, fraction_bits), one<Wide>(fraction_bits), Rounding::truncate);
  if (units == 0) return std::nullopt;
  return wrap<Wide>(rounded<Wide>(ulps<Wide>(n, fraction_bits), units, rule),
                    word_bits(fraction_bits));
}

}  // namespace

Word add(Word a, Word b, int fraction_bits) {
  return wrap<Wide>(ulps<Wide>(a, fraction_bits) + ulps<Wide>(b, fraction_bits),
                    word_bits(fraction_bits));
}

Word sub(Word a, Word b, int fraction_bits) {
  return wrap<Wide>(ulps<Wide>(a, fraction_bits) - ulps<Wide>(b, fraction_bits),
                    word_bits(fraction_bits));
}

Word mul(Word a, Word b, Rounding rule, int fraction_bits) {
  return wrap<Wide>(exact_product<Wide>(a, b, rule, fraction_bits), word_bits(fraction_bits));
}

std::optional<Word> div(Word n, Word d, DivideRule rule, int fraction_bits) {
  switch (rule) {
    case DivideRule::i386_rounded:
      return i386_rounded(n, d, fraction_bits);
    case DivideRule::i386_unrounded:
      return i386_unrounded(n, d, fraction_bits);
    case DivideRule::i8088_rounded:
      return i8088(n, d, Rounding::half_away, fraction_bits);
    case DivideRule::i8088_unrounded:
      return i8088(n, d, Rounding::truncate, fraction_bits);
  }
  throw std::invalid_argument("no such divide rule");
}

std::optional<Word> quotient(Word n, Word d, Rounding rule, int fraction_bits) {
  const auto exact = exact_quotient<Wide>(n, d, rule, fraction_bits);
  if (!exact) return std::nullopt;
  return wrap<Wide>(*exact, word_bits(fraction_bits));
}

Word mul_add(Word a, Word b, Word c, Rounding rule, int fraction_bits) {
  return wrap(exact_mul_add(a, b, c, rule, fraction_bits), word_bits(fraction_bits));
}

Word dot(std::span<const Word> a, std::span<const Word> b, Rounding rule, int fraction_bits) {
  return wrap(exact_dot(a, b, rule, fraction_bits), word_bits(fraction_bits));
}

Word lerp(Word a, Word b, Word t, Rounding rule, int fraction_bits) {
  return wrap(exact_lerp(a, b, t, rule, fraction_bits), word_bits(fraction_bits));
}

}  // namespace oracle
