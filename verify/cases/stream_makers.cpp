#include "verify/cases/stream_makers.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace fixproof::cases {

namespace {

/// Returns an odd number of random width, 1 ... 2^widest - 1; `widest` is at least 1.
std::int64_t odd(Draw& draw, int widest) { return draw.magnitude(widest) | 1; }

/// Returns -1, 0 or 1.
std::int64_t beside(Draw& draw) { return static_cast<std::int64_t>(draw.below(3)) - 1; }

/// Returns the inverse of the odd `a` modulo 2^64. `a` itself is right to three bits, and each
/// Newton step doubles the number of right bits.
std::uint64_t inverse(std::uint64_t a) {
  std::uint64_t x = a;
  for (int step = 0; step < 5; ++step) x *= 2 - a * x;
  return x;
}

constexpr std::array<std::uint32_t, 62> hard_words{
    0x01faf7eb, 0x046936f4, 0x06772dbb, 0x0c54eeec, 0x0cc9a52c, 0x0cd31bf4, 0x0d518b65, 0x0db520b1,
    0x10e4c31e, 0x112256a7, 0x11776e51, 0x12a821f9, 0x12b212c2, 0x138e71de, 0x13c02e71, 0x15ee4b90,
    0x1d0d85b5, 0x1e70a1b9, 0x24f7478a, 0x25fa3386, 0x26e5159d, 0x2f385ad3, 0x307d4dca, 0x378b3a20,
    0x3c7a30eb, 0x4162745d, 0x44e9eb75, 0x46f017e3, 0x490df2e2, 0x4a5eabdf, 0x4a5f5825, 0x4d82c570,
    0x4da561d9, 0x4e638194, 0x4ee059f8, 0x5052868b, 0x52345ddb, 0x57e413ee, 0x5aa1c663, 0x5ba9cfa5,
    0x5c941e7f, 0x5d12f515, 0x6020f394, 0x60cf72d8, 0x6130d234, 0x650cf7f4, 0x66583d37, 0x6847fe84,
    0x6873a725, 0x6c6b7c74, 0x6e6a8d98, 0x6eeb24cd, 0x6f29ca6b, 0x6ff9118d, 0x734c79ae, 0x776c1f1d,
    0x7b11621d, 0x7b81a8ae, 0x7d40e938, 0x7d9430e1, 0x7eb7204d, 0x7ee9956a};

using Quaternion = std::array<std::int64_t, 4>;

/// Returns the rotation matrix of a quaternion (w, x, y, z), row-major in units, rounded to
/// nearest. It uses integers only, because sines differ between libraries and cases must not.
std::array<std::int64_t, 9> rotation_of(const Quaternion& q, const Format& format) {
  const auto [w, x, y, z] = q;
  const std::int64_t norm = w * w + x * x + y * y + z * z;
  const std::array<std::int64_t, 9> scaled{
      w * w + x * x - y * y - z * z, 2 * (x * y - w * z),           2 * (x * z + w * y),
      2 * (x * y + w * z),           w * w - x * x + y * y - z * z, 2 * (y * z - w * x),
      2 * (x * z - w * y),           2 * (y * z + w * x),           w * w - x * x - y * y + z * z};
  std::array<std::int64_t, 9> rows{};
  std::transform(scaled.begin(), scaled.end(), rows.begin(), [&](std::int64_t entry) {
    const std::int64_t twice = 2 * entry * format.one();
    return (twice + (twice < 0 ? -norm : norm)) / (2 * norm);
  });
  return rows;
}

Quaternion random_quaternion(Draw& draw) {
  Quaternion q{};
  for (auto& part : q) part = static_cast<std::int64_t>(draw.below(2047)) - 1023;
  if (q == Quaternion{}) q[0] = 1;
  return q;
}

/// Writes the nine coefficients and a random translation of up to an eighth of the range.
void write_matrix(const std::array<std::int64_t, 9>& rows, Draw& draw, const Format& format,
                  std::span<std::uint32_t> matrix) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) matrix[4 * i + k] = format.word(rows.at(3 * i + k));
    matrix[4 * i + 3] = format.word(draw.either_sign(draw.magnitude(format.word_bits - 4)));
  }
}

}  // namespace

std::uint32_t scaled_word(Draw& draw, const Format& format) {
  return format.word(draw.either_sign(draw.magnitude(format.word_bits)));
}

Pair product_tie(Draw& draw, const Format& format) {
  // A tie has exactly F - 1 factors of two in the product.
  const int twos = format.fraction_bits - 1;
  const int in_a = static_cast<int>(draw.below(static_cast<std::uint64_t>(twos) + 1));
  const int in_b = twos - in_a;
  const std::int64_t a = odd(draw, format.word_bits - 1 - in_a) << in_a;
  const std::int64_t b = odd(draw, format.word_bits - 1 - in_b) << in_b;
  return {draw.either_sign(a), draw.either_sign(b)};
}

Pair near_product_tie(Draw& draw, const Format& format) {
  const std::int64_t a = odd(draw, format.word_bits - 1);
  const std::int64_t half = format.one() / 2;
  const auto wanted = static_cast<std::uint64_t>(half + 1);
  // The low F bits of b make the fraction of the product just above one half, or with the other
  // sign just below it. The other bits are free.
  const auto low = static_cast<std::int64_t>(wanted * inverse(static_cast<std::uint64_t>(a))) &
                   (format.one() - 1);
  const std::int64_t high = draw.magnitude(format.word_bits - 1 - format.fraction_bits);
  const std::int64_t b = high * format.one() + low;
  Pair pair{draw.either_sign(a), draw.either_sign(b)};
  if (draw.coin()) std::swap(pair.first, pair.second);
  return pair;
}

Pair quotient_tie(Draw& draw, const Format& format) {
  // n 2^F = (q + 1/2) d holds for d = 2^(F+1) m and n = m (2q + 1).
  const std::int64_t m = std::max<std::int64_t>(1, draw.magnitude(format.fraction_bits - 2));
  const std::int64_t d = 2 * format.one() * m;
  std::int64_t n = m * odd(draw, format.word_bits - 1);
  while (n >= format.limit()) n = m * (n / m / 2 | 1);
  return {draw.either_sign(n), draw.either_sign(d)};
}

Pair near_quotient_tie(Draw& draw, const Format& format) {
  const std::int64_t d = std::max<std::int64_t>(3, odd(draw, format.word_bits - 1));
  // n 2^F leaves this remainder if n is the remainder halved F times modulo the odd d.
  std::int64_t n = draw.coin() ? (d + 1) / 2 : (d - 1) / 2;
  for (int i = 0; i < format.fraction_bits; ++i) n = n % 2 == 0 ? n / 2 : (n + d) / 2;
  // Adding d keeps the remainder; the quotient must stay below 2^2F units.
  const std::int64_t most = std::min(format.limit(), d << format.fraction_bits);
  const std::int64_t steps = (most - 1 - n) / d;
  if (steps > 0) n += d * (draw.magnitude(format.word_bits - 1) % (steps + 1));
  return {draw.either_sign(n), draw.either_sign(d)};
}

Pair whole_divisor_tie(Draw& draw, const Format& format) {
  const int whole_bits = format.word_bits - 1 - format.fraction_bits;
  const std::int64_t whole = std::max<std::int64_t>(1, draw.magnitude(whole_bits));
  const std::int64_t fraction = draw.coin() ? 0 : draw.magnitude(format.fraction_bits);
  const std::int64_t quotients = format.limit() / whole;
  const std::int64_t q = draw.magnitude(format.word_bits - 1) % quotients;
  const std::int64_t n = q * whole + whole / 2 + beside(draw);
  return {draw.either_sign(n), draw.either_sign(whole * format.one() + fraction)};
}

Pair large_quotient(Draw& draw, const Format& format) {
  // The quotient is near the end of the signed or of the unsigned range of a word.
  const bool is_signed = draw.coin();
  const std::int64_t edge = is_signed ? format.limit() : 2 * format.limit();
  const int widest = is_signed ? format.fraction_bits : format.fraction_bits - 1;
  const std::int64_t d = std::max<std::int64_t>(1, draw.magnitude(widest));
  const std::int64_t q = edge + static_cast<std::int64_t>(draw.below(7)) - 3;
  const std::int64_t n = (q * d >> format.fraction_bits) + beside(draw);
  return {draw.either_sign(std::min(n, format.limit())), draw.either_sign(d)};
}

Pair small_divisor(Draw& draw, const Format& format) {
  const std::int64_t n = draw.magnitude(format.word_bits - 1);
  return {draw.either_sign(n), draw.either_sign(draw.magnitude(format.fraction_bits))};
}

Pair fault_edge(Draw& draw, const Format& format) {
  const std::int64_t n = draw.magnitude(format.word_bits - 1);
  // The 386 faults up to |d| = |n| / 2^F, the 8088 below |d| = 1.0.
  const std::int64_t edge = draw.coin() ? n >> format.fraction_bits : format.one();
  return {draw.either_sign(n), draw.either_sign(edge + beside(draw))};
}

std::uint32_t root_tie(Draw& draw, const Format& format) {
  // A root r + 1/2 has the radicand r^2 + r + 1/4, which is 2^F times the operand.
  const int root_bits = (format.word_bits - 1 + format.fraction_bits) / 2;
  const std::int64_t r = draw.magnitude(root_bits);
  const std::int64_t x = ((r * r + r) >> format.fraction_bits) + (draw.coin() ? 1 : 0);
  return format.word(std::min(x, format.limit() - 1));
}

std::uint32_t quarter_turn(Draw& draw, const Format& format) {
  constexpr int bits = 46;
  constexpr std::int64_t half_pi =
      0x6487ed5110b4;  // pi/2 * 2^46, in error by less than 2^-15 units
  const std::int64_t most = (format.limit() << (bits - format.fraction_bits)) / half_pi;
  const auto turns = static_cast<std::int64_t>(draw.below(static_cast<std::uint64_t>(most) + 1));
  const int dropped = bits - format.fraction_bits;
  const std::int64_t nearest = (turns * half_pi + (std::int64_t{1} << (dropped - 1))) >> dropped;
  return format.word(draw.either_sign(nearest + beside(draw)));
}

std::span<const std::uint32_t> hard_angles() { return hard_words; }

void rotation(Draw& draw, const Format& format, std::span<std::uint32_t> words) {
  write_matrix(rotation_of(random_quaternion(draw), format), draw, format, words.first(12));
  const auto rest = words.subspan(12);
  if (rest.size() == 12) {
    write_matrix(rotation_of(random_quaternion(draw), format), draw, format, rest);
    return;
  }
  for (auto& word : rest)
    word = format.word(draw.either_sign(draw.magnitude(format.word_bits - 7)));
}

void axes(Draw& draw, const Format& format, std::span<std::uint32_t> words) {
  std::array<std::size_t, 3> order{0, 1, 2};
  for (auto step = draw.below(6); step > 0; --step)
    std::next_permutation(order.begin(), order.end());
  for (auto& word : words) word = scaled_word(draw, format);
  // In a product of two transforms, either one can have the rotated axes.
  const auto turned = words.size() == 24 && draw.coin() ? words.subspan(12) : words.first(12);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) turned[4 * i + k] = 0;
    turned[4 * i + order.at(i)] = format.word(draw.either_sign(format.one()));
  }
}

void transform_tie(Draw& draw, const Format& format, std::span<std::uint32_t> words) {
  for (auto& word : words) word = scaled_word(draw, format);
  const int twos = format.fraction_bits - 1;
  const auto tied = [&](int factors) {
    return format.word(draw.either_sign(odd(draw, format.word_bits - 1 - factors) << factors));
  };
  const std::size_t columns = words.size() == 24 ? 4 : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    // Column k of the first transform multiplies coordinate k, or row k of the second transform.
    const auto in_first = static_cast<int>(draw.below(static_cast<std::uint64_t>(twos) + 1));
    for (std::size_t i = 0; i < 3; ++i) words[4 * i + k] = tied(in_first);
    for (std::size_t c = 0; c < columns; ++c) words[12 + columns * k + c] = tied(twos - in_first);
  }
}

}  // namespace fixproof::cases
