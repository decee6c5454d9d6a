#include "verify/cases/format_makers.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace fixproof::cases {

namespace {

/// Returns 2^bits - 1, for 0 ... 64 bits.
std::uint64_t ones(int bits) { return bits == 0 ? 0 : ~std::uint64_t{0} >> (64 - bits); }

/// 10^exponent; empty above 2^64.
std::optional<std::uint64_t> power_of_ten(int exponent) {
  constexpr int most = 19;
  if (exponent < 0 || exponent > most) return std::nullopt;
  std::uint64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

/// The largest i with factor * 10^i at most `most`; -1 if there is none.
int digits_below(std::uint64_t most, std::uint64_t factor) {
  int digits = -1;
  for (std::uint64_t left = most / factor; left != 0; left /= 10) ++digits;
  return digits;
}

/// An odd number of 1 ... `most`, for a `most` of at least 1.
std::uint64_t odd_up_to(Draw& draw, std::uint64_t most) {
  return odd_number(draw, std::max(1, static_cast<int>(std::bit_width(most)) - 1));
}

/// Either sign for both. A product modulo 2^word_bits remains a tie.
WordPair either_sign(Draw& draw, std::uint64_t a, std::uint64_t b, const Format& format) {
  const std::uint64_t first = cases::either_sign(draw, a, format);
  return {first, cases::either_sign(draw, b, format)};
}

/// Returns the inverse of the odd `a` modulo 2^64. `a` itself is right to three bits, and each
/// Newton step doubles the number of right bits.
std::uint64_t inverse_of(std::uint64_t a) {
  std::uint64_t x = a;
  for (int step = 0; step < 5; ++step) x *= 2 - a * x;
  return x;
}

/// Returns r (r + 1) / 2^shift rounded down, modulo 2^64. 0 <= shift <= 64
std::uint64_t rectangle(std::uint64_t r, int shift) {
  const std::uint64_t s = r + 1;  // r is below 2^64 - 1
  const std::uint64_t low = (r & ones(32)) * (s & ones(32));
  const std::uint64_t crossed = (r >> 32U) * (s & ones(32)) + (low >> 32U);
  const std::uint64_t other = (r & ones(32)) * (s >> 32U) + (crossed & ones(32));
  const std::uint64_t high = (r >> 32U) * (s >> 32U) + (crossed >> 32U) + (other >> 32U);
  const std::uint64_t bottom = other << 32U | (low & ones(32));
  if (shift == 0) return bottom;
  return shift == 64 ? high : high << (64 - shift) | bottom >> shift;
}

}  // namespace

std::uint64_t any_number(Draw& draw, int widest) {
  const int width = draw.between(0, widest);
  if (width == 0) return 0;
  return (draw.bits() & ones(width)) | std::uint64_t{1} << (width - 1);
}

std::uint64_t odd_number(Draw& draw, int widest) {
  return any_number(draw, draw.between(1, widest)) | 1;
}

std::uint64_t either_sign(Draw& draw, std::uint64_t word, const Format& format) {
  const bool negate = draw.coin() && format.is_signed;
  return (negate ? 0 - word : word) & all_ones(format);
}

std::uint64_t any_word(Draw& draw, const Format& format) { return draw.bits() & all_ones(format); }

std::uint64_t any_width(Draw& draw, const Format& format) {
  return either_sign(draw, any_number(draw, format.word_bits), format);
}

std::optional<Format> maker_format(Stream stream, const Variant& variant) {
  Format format = operand_format(variant);
  const Format& result = variant.format;
  const int bits = magnitude_bits(format);
  const auto with = [&](int fraction_bits, bool has_cases) -> std::optional<Format> {
    if (!has_cases) return std::nullopt;
    format.fraction_bits = fraction_bits;
    return format;
  };
  const int of_product = 2 * format.fraction_bits - result.fraction_bits;
  if (format.is_decimal || result.is_decimal) {
    const bool both = format.is_decimal && result.is_decimal;
    const std::uint64_t most = highest(format);
    switch (stream) {
      case Stream::product_ties:
        return with(of_product,
                    both && of_product > 0 &&
                        of_product - 1 <= digits_below(most, 1) + digits_below(most, 5));
      case Stream::quotient_ties:
        return with(result.fraction_bits, both && result.fraction_bits <= digits_below(most, 2));
      case Stream::near_product_ties:
      case Stream::near_quotient_ties:
      case Stream::large_quotients:
      case Stream::small_divisors:
      case Stream::root_ties:
        return std::nullopt;
      default:
        return format;
    }
  }
  const auto in_word = [&](int fraction_bits) {
    return with(fraction_bits, fraction_bits >= 0 && fraction_bits <= format.word_bits);
  };
  switch (stream) {
    case Stream::product_ties:
      // A tie has exactly F - 1 factors of two in the product.
      return with(of_product, of_product > 0 && of_product - 1 <= 2 * (bits - 1));
    case Stream::near_product_ties:
      return with(of_product, of_product > 0 && of_product <= format.word_bits);
    case Stream::quotient_ties:
      // Only divisors of 2^(F+1) units and their multiples have such quotients.
      return with(result.fraction_bits,
                  result.fraction_bits >= 0 && bits >= result.fraction_bits + 2);
    case Stream::near_quotient_ties:
      return in_word(result.fraction_bits);
    case Stream::large_quotients:
      return in_word(bits - magnitude_bits(result) + result.fraction_bits);
    case Stream::small_divisors:
      return in_word(format.fraction_bits);
    case Stream::root_ties:
      return in_word(2 * result.fraction_bits - format.fraction_bits);
    case Stream::ratio_ties:
    case Stream::near_ratio_ties:
    case Stream::large_ratios:
      return with(format.fraction_bits, !variant.from);
    default:
      return format;
  }
}

WordPair product_tie_in(Draw& draw, const Format& format) {
  if (format.is_decimal) {
    // 10^i u 5 10^j v, for odd u and v, is an odd multiple of half of 10^(i+j+1).
    const std::uint64_t most = highest(format);
    const int tens = format.fraction_bits - 1;
    const int in_a = draw.between(std::max(0, tens - digits_below(most, 5)),
                                  std::min(tens, digits_below(most, 1)));
    const std::uint64_t first = *power_of_ten(in_a);
    const std::uint64_t second = 5 * *power_of_ten(tens - in_a);
    const std::uint64_t a = first * odd_up_to(draw, most / first);
    return either_sign(draw, a, second * odd_up_to(draw, most / second), format);
  }
  const int twos = format.fraction_bits - 1;
  const int most = magnitude_bits(format) - 1;
  const int in_a = draw.between(std::max(0, twos - most), std::min(twos, most));
  const int in_b = twos - in_a;
  const std::uint64_t a = odd_number(draw, most + 1 - in_a) << in_a;
  const std::uint64_t b = odd_number(draw, most + 1 - in_b) << in_b;
  return either_sign(draw, a, b, format);
}

WordPair near_product_tie_in(Draw& draw, const Format& format) {
  const std::uint64_t a = odd_number(draw, magnitude_bits(format));
  const std::uint64_t half = std::uint64_t{1} << (format.fraction_bits - 1);
  // The low F bits of b decide the fraction of the product. The other bits are free.
  const std::uint64_t beside = draw.coin() ? half + 1 : half - 1;
  const std::uint64_t low = beside * inverse_of(a) & ones(format.fraction_bits);
  const std::uint64_t high = any_number(draw, format.word_bits) & ~ones(format.fraction_bits);
  const WordPair pair = either_sign(draw, a, high | low, format);
  if (draw.coin()) return pair;
  return {pair.second, pair.first};
}

WordPair quotient_tie_in(Draw& draw, const Format& format) {
  // n 2^F = (q + 1/2) d holds for d = 2^(F+1) m and n = m (2q + 1), and likewise for 10^F.
  const int bits = magnitude_bits(format);
  if (format.is_decimal) {
    const std::uint64_t most = highest(format);
    const std::uint64_t step = 2 * *power_of_ten(format.fraction_bits);
    const std::uint64_t m = odd_up_to(draw, most / step);
    return either_sign(draw, m * odd_up_to(draw, most / m), m * step, format);
  }
  const std::uint64_t m = odd_number(draw, bits - format.fraction_bits - 1);
  const std::uint64_t n =
      m * odd_number(draw, std::max(1, bits - static_cast<int>(std::bit_width(m))));
  return either_sign(draw, n, m << (format.fraction_bits + 1), format);
}

WordPair near_quotient_tie_in(Draw& draw, const Format& format) {
  const std::uint64_t d = std::max<std::uint64_t>(3, odd_number(draw, magnitude_bits(format)));
  // n 2^F leaves this remainder if n is the remainder halved F times modulo the odd d.
  std::uint64_t n = d / 2 + (draw.coin() ? 1 : 0);
  for (int i = 0; i < format.fraction_bits; ++i) n = n / 2 + (n % 2 == 0 ? 0 : d / 2 + 1);
  // Adding d keeps the remainder.
  const std::uint64_t steps = (highest(format) - n) / d;
  if (steps > 0) n += d * (draw.bits() % (steps + 1));
  return either_sign(draw, n, d, format);
}

WordPair large_quotient_in(Draw& draw, const Format& format) {
  const int bits = magnitude_bits(format);
  const int shift = bits - format.fraction_bits;
  const std::uint64_t d = any_number(draw, std::min(bits, format.fraction_bits)) | 1;
  const std::uint64_t n = shift >= 0 ? (shift > 63 ? 0 : d << shift) : d >> -shift;
  const std::uint64_t beside = draw.below(3) - 1;
  return either_sign(draw, n + beside, d, format);
}

WordPair small_divisor_in(Draw& draw, const Format& format) {
  const std::uint64_t n = any_number(draw, magnitude_bits(format));
  const int widest = std::min(format.fraction_bits, magnitude_bits(format));
  return either_sign(draw, n, any_number(draw, widest), format);
}

std::uint64_t root_tie_in(Draw& draw, const Format& format) {
  // A root r + 1/2 has the radicand r (r + 1) + 1/4, which is 2^F times the operand.
  const int bits = magnitude_bits(format);
  // The largest root has half of these bits, rounded up; 64-bit words leave no room for that.
  const int root_bits = (bits + format.fraction_bits + (bits < 64 ? 1 : 0)) / 2;
  std::uint64_t r = std::min(any_number(draw, root_bits), ~std::uint64_t{} - 1);
  while (rectangle(r, format.fraction_bits) >= highest(format)) r /= 2;
  return rectangle(r, format.fraction_bits) + (draw.coin() ? 1 : 0);
}

std::uint64_t extreme_word(Draw& draw, const Format& format) {
  const std::uint64_t most = highest(format);
  const std::array<std::uint64_t, 6> words{most, most + 1, most + 2, 0, 1, ~std::uint64_t{0}};
  return words.at(draw.below(words.size())) & all_ones(format);
}

}  // namespace fixproof::cases
