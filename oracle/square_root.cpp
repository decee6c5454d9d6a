#include "oracle/exact.hpp"
#include "oracle/unbounded.hpp"

namespace oracle {

template <class Int>
std::optional<Int> exact_root(Word x, Rounding rule, int fraction_bits) {
  const Int value = ulps<Int>(x, fraction_bits);
  if (value < 0) return std::nullopt;
  // sqrt(value / one) * one, in ulps, is the root of value * one.
  const Int radicand = value * one<Int>(fraction_bits);
  const Int floor = boost::multiprecision::sqrt(radicand);
  if (rule == Rounding::floor || rule == Rounding::truncate) return floor;
  const Int doubled_midpoint = 2 * floor + 1;
  const bool above_midpoint = 4 * radicand > doubled_midpoint * doubled_midpoint;
  return above_midpoint ? floor + 1 : floor;
}

template std::optional<Integer> exact_root<Integer>(Word, Rounding, int);
template std::optional<Wide> exact_root<Wide>(Word, Rounding, int);

std::optional<Word> sqrt(Word x, int fraction_bits) {
  const auto root = exact_root<Wide>(x, Rounding::half_up, fraction_bits);
  if (!root) return std::nullopt;
  return wrap<Wide>(*root, word_bits(fraction_bits));
}

}  // namespace oracle
