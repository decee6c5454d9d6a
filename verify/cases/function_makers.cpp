#include "verify/cases/function_makers.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>
#include <utility>

namespace fixproof::cases {

namespace {

int width_of(std::uint64_t number) { return static_cast<int>(std::bit_width(number)); }

/// Returns -1, 0 or 1, modulo 2^64.
std::uint64_t one_off(Draw& draw) { return draw.below(3) - 1; }

/// Returns a number of 0 ... `most`. Every width is about equally likely.
std::uint64_t any_up_to(Draw& draw, std::uint64_t most) {
  return std::min(most, any_number(draw, width_of(most)));
}

WordTriple either_sign(Draw& draw, const WordTriple& words, const Format& format) {
  WordTriple made{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    made.at(i) = cases::either_sign(draw, words.at(i), format);
  }
  return made;
}

/// a * b modulo c, for a and b below c. No sum exceeds c.
std::uint64_t product_modulo(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  const auto sum = [c](std::uint64_t x, std::uint64_t y) {
    return x >= c - y ? x - (c - y) : x + y;
  };
  std::uint64_t product = 0;
  for (; b != 0; b >>= 1U) {
    if (b % 2 != 0) product = sum(product, a);
    a = sum(a, a);
  }
  return product;
}

/// Returns the inverse of a modulo c > 1. a and c have no common factor.
std::uint64_t inverse_modulo(std::uint64_t a, std::uint64_t c) {
  // Euclid's algorithm. The factors of `a` alternate in sign, and none exceeds c.
  std::uint64_t rest = a % c;
  std::uint64_t divisor = c;
  std::uint64_t of_rest = 1;
  std::uint64_t of_divisor = 0;
  bool is_negative = false;
  while (rest != 1) {
    const std::uint64_t quotient = divisor / rest;
    divisor = std::exchange(rest, divisor % rest);
    of_divisor = std::exchange(of_rest, of_divisor + quotient * of_rest);
    is_negative = !is_negative;
  }
  return is_negative ? c - of_rest : of_rest;
}

/// Returns z so that x^2 + y^2 + z^2 is r^2 + r + extra for r = z + t; empty if no word is it.
std::optional<std::uint64_t> last_edge(std::uint64_t x, std::uint64_t y, std::uint64_t t,
                                       std::uint64_t extra, const Format& format) {
  // x^2 + y^2 = z (2t + 1) + t^2 + t + extra
  const std::uint64_t squares = x * x + y * y;
  const std::uint64_t less = t * t + t + extra;
  if (squares < less || (squares - less) % (2 * t + 1) != 0) return std::nullopt;
  const std::uint64_t z = (squares - less) / (2 * t + 1);
  return z <= highest(format) ? std::optional(z) : std::nullopt;
}

}  // namespace

WordPair half_multiple(Draw& draw, const Format& format) {
  const std::uint64_t d = std::max<std::uint64_t>(1, any_number(draw, magnitude_bits(format)));
  const std::uint64_t half = d / 2 + (draw.coin() ? d % 2 : 0);
  std::uint64_t n = d * any_up_to(draw, highest(format) / d);
  if (n > highest(format) - half) n -= d;
  if (draw.coin()) n += half;
  n += one_off(draw);
  const std::uint64_t dividend = either_sign(draw, n, format);
  return {dividend, either_sign(draw, d, format)};
}

WordTriple ratio_tie(Draw& draw, const Format& format) {
  // a b = c (q + 1/2) holds for a = k u, b = m v and c = 2 k m, if u and v are odd.
  const int bits = magnitude_bits(format);
  const std::uint64_t k = std::max<std::uint64_t>(1, any_number(draw, draw.between(0, bits - 1)));
  const std::uint64_t m =
      std::max<std::uint64_t>(1, any_number(draw, std::max(0, bits - 1 - width_of(k))));
  const std::uint64_t a = k * odd_number(draw, bits - width_of(k));
  const std::uint64_t b = m * odd_number(draw, bits - width_of(m));
  return either_sign(draw, {a, b, 2 * k * m}, format);
}

WordTriple near_ratio_tie(Draw& draw, const Format& format) {
  const int bits = magnitude_bits(format);
  const std::uint64_t c = std::max<std::uint64_t>(3, odd_number(draw, bits));
  std::uint64_t a = std::max<std::uint64_t>(1, any_number(draw, bits));
  while (std::gcd(a, c) != 1) a /= std::gcd(a, c);
  const std::uint64_t rest = c / 2 + (draw.coin() ? 1 : 0);
  std::uint64_t b = product_modulo(rest, inverse_modulo(a, c), c);
  b += c * any_up_to(draw, (highest(format) - b) / c);
  return either_sign(draw, draw.coin() ? WordTriple{a, b, c} : WordTriple{b, a, c}, format);
}

WordTriple large_ratio(Draw& draw, const Format& format) {
  const int bits = magnitude_bits(format);
  const int shift = draw.between(0, bits - 1);
  const std::uint64_t c = std::max<std::uint64_t>(1, any_number(draw, bits - shift));
  const std::uint64_t a = (highest(format) >> shift) + one_off(draw);
  return either_sign(draw, {a, (c << shift) + one_off(draw), c}, format);
}

WordTriple whole_length(Draw& draw, const Format& format) {
  // The diagonal of these edges is k^2 + l^2 + m^2 + n^2.
  const std::uint64_t below = format.word_bits == 8 ? 4 : 8;
  const auto number = [&] { return static_cast<std::int64_t>(draw.below(below)); };
  const std::int64_t k = number() + 1;
  const std::int64_t l = number();
  const std::int64_t m = number();
  const std::int64_t n = number();
  std::array<std::int64_t, 3> edges{k * k + l * l - m * m - n * n, 2 * (k * n + l * m),
                                    2 * (l * n - k * m)};
  const std::uint64_t most =
      highest(format) / static_cast<std::uint64_t>(k * k + l * l + m * m + n * n);
  // One more than the largest scale makes the length overflow.
  const std::uint64_t scale =
      std::max<std::uint64_t>(1, draw.coin() ? any_up_to(draw, most) : most + draw.below(2));
  WordTriple words{};
  const std::uint64_t turn = draw.below(3);
  for (std::size_t i = 0; i < words.size(); ++i) {
    words.at((i + turn) % 3) = static_cast<std::uint64_t>(std::abs(edges.at(i))) * scale;
  }
  if (draw.coin()) words[0] += one_off(draw);
  return either_sign(draw, words, format);
}

WordTriple near_length_tie(Draw& draw, const Format& format) {
  std::uint64_t t = draw.below(format.word_bits == 8 ? 2 : 32);
  const std::uint64_t step = 2 * t + 1;
  const int widest = (magnitude_bits(format) - 2 + width_of(step)) / 2;
  const std::uint64_t x = any_number(draw, widest);
  const std::uint64_t y = any_number(draw, widest);
  const std::uint64_t extra = draw.coin() ? 1 : 0;
  WordTriple found{1, 0, 1 - extra};  // 2 or 1 = 1 * 2 + extra, for r = 1 or 0
  const auto try_at = [&](std::uint64_t a, std::uint64_t b, std::uint64_t with) {
    const auto z = last_edge(a, b, with, extra, format);
    if (z) found = {a, b, *z};
    return z.has_value();
  };
  // About half of the residues of y have an x.
  bool done = false;
  for (std::uint64_t i = 0; i < step * step && !done; ++i) {
    done = try_at(x + i % step, y + i / step, t);
  }
  for (int fewer = 0; !done && fewer < widest; ++fewer) done = try_at(x >> fewer, y >> fewer, 0);
  const std::uint64_t turn = draw.below(3);
  std::rotate(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(turn), found.end());
  return either_sign(draw, found, format);
}

}  // namespace fixproof::cases
