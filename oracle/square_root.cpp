#include "oracle/exact.hpp"
#include "oracle/unbounded.hpp"

namespace oracle {

std::optional<Integer> exact_root(Word x, Rounding rule, int fraction_bits) {
  const Integer value = ulps(x, fraction_bits);
  if (value < 0) return std::nullopt;
  // sqrt(value / one) * one, in ulps, is the root of value * one.
  const Integer radicand = value * one(fraction_bits);
  const Integer floor = boost::multiprecision::sqrt(radicand);
  if (rule == Rounding::floor || rule == Rounding::truncate) return floor;
  const Integer doubled_midpoint = 2 * floor + 1;
  const bool above_midpoint = 4 * radicand > doubled_midpoint * doubled_midpoint;
  return above_midpoint ? floor + 1 : floor;
}

std::optional<Word> sqrt(Word x, int fraction_bits) {
  const auto root = exact_root(x, Rounding::half_up, fraction_bits);
  if (!root) return std::nullopt;
  return wrap(*root, word_bits(fraction_bits));
}

}  // namespace oracle
