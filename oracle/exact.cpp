#include "oracle/exact.hpp"

#include <stdexcept>

namespace oracle {
namespace {

/// wrap() of at most 32 bits.
template <class Int = Integer>
Word word(const std::type_identity_t<Int>& value, const Format& format) {
  return static_cast<Word>(wrap<Int>(value, format));
}

/// The 386 divides the magnitudes as unsigned integers and ignores the sign bit, so only a quotient
/// too wide for an unsigned word faults, before rounding.
std::optional<Word> i386_rounded(Word n, Word d, const Format& format) {
  const auto truncated = exact_quotient<Wide>(n, d, Rounding::truncate, format);
  if (!truncated || abs(*truncated) >= Wide(1) << format.bits) return std::nullopt;
  return quotient(n, d, Rounding::half_away, format);
}

std::optional<Word> i386_unrounded(Word n, Word d, const Format& format) {
  const auto truncated = exact_quotient<Wide>(n, d, Rounding::truncate, format);
  if (!truncated || !fits<Wide>(*truncated, format)) return std::nullopt;
  return word<Wide>(*truncated, format);
}

/// The 8088 divides by the whole part of the divisor's magnitude, so the quotient has the scale of
/// n.
std::optional<Word> i8088(Word n, Word d, Rounding rule, const Format& format) {
  const Wide units = rounded<Wide>(ulps<Wide>(d, format), one<Wide>(format), Rounding::truncate);
  if (units == 0) return std::nullopt;
  return word<Wide>(rounded<Wide>(ulps<Wide>(n, format), units, rule), format);
}

}  // namespace

Word add(Word a, Word b, const Format& format) {
  return word<Wide>(ulps<Wide>(a, format) + ulps<Wide>(b, format), format);
}

Word sub(Word a, Word b, const Format& format) {
  return word<Wide>(ulps<Wide>(a, format) - ulps<Wide>(b, format), format);
}

Word mul(Word a, Word b, Rounding rule, const Format& format) {
  return word<Wide>(exact_product<Wide>(a, b, rule, format), format);
}

std::optional<Word> div(Word n, Word d, DivideRule rule, const Format& format) {
  switch (rule) {
    case DivideRule::i386_rounded:
      return i386_rounded(n, d, format);
    case DivideRule::i386_unrounded:
      return i386_unrounded(n, d, format);
    case DivideRule::i8088_rounded:
      return i8088(n, d, Rounding::half_away, format);
    case DivideRule::i8088_unrounded:
      return i8088(n, d, Rounding::truncate, format);
  }
  throw std::invalid_argument("no such divide rule");
}

std::optional<Word> quotient(Word n, Word d, Rounding rule, const Format& format) {
  const auto exact = exact_quotient<Wide>(n, d, rule, format);
  if (!exact) return std::nullopt;
  return word<Wide>(*exact, format);
}

Word mul_add(Word a, Word b, Word c, Rounding rule, const Format& format) {
  return word(exact_mul_add(a, b, c, rule, format), format);
}

Word dot(std::span<const Word> a, std::span<const Word> b, Rounding rule, const Format& format) {
  return word(exact_dot(a, b, rule, format), format);
}

Word lerp(Word a, Word b, Word t, Rounding rule, const Format& format) {
  return word(exact_lerp(a, b, t, rule, format), format);
}

std::optional<Word> sqrt(Word x, const Format& format) {
  const auto root = exact_root<Wide>(x, Rounding::half_up, format);
  if (!root) return std::nullopt;
  return word<Wide>(*root, format);
}

}  // namespace oracle
