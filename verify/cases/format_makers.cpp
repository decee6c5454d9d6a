#include "verify/cases/format_makers.hpp"

#include <algorithm>
#include <bit>

namespace fixproof::cases {

namespace {

/// Returns 2^bits - 1, for 0 ... 64 bits.
std::uint64_t ones(int bits) { return bits == 0 ? 0 : ~std::uint64_t{0} >> (64 - bits); }

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

std::uint64_t largest(const Format& format) {
  return all_ones(format) >> (format.is_signed ? 1 : 0);
}

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

WordPair product_tie_in(Draw& draw, const Format& format) {
  // A tie has exactly F - 1 factors of two in the product.
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
  // n 2^F = (q + 1/2) d holds for d = 2^(F+1) m and n = m (2q + 1).
  const int bits = magnitude_bits(format);
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
  const std::uint64_t steps = (largest(format) - n) / d;
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
  while (rectangle(r, format.fraction_bits) >= largest(format)) r /= 2;
  return rectangle(r, format.fraction_bits) + (draw.coin() ? 1 : 0);
}

}  // namespace fixproof::cases
