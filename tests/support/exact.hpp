/// @file
/// The reference arithmetic of the tests: exact fractions of 128-bit integers, rounded by the
/// definition of each rule. It shares only the names of the rules with fixed/, and nothing with
/// x86model/ and oracle/.
#pragma once

#include <cstdint>

#include "fixed/policy.hpp"
#ifndef __SIZEOF_INT128__
#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace exact {

#ifdef __SIZEOF_INT128__
__extension__ using integer = __int128;
#else
using integer = boost::multiprecision::int128_t;
#endif

/// numerator / denominator, with a positive denominator.
struct fraction {
  integer numerator;
  integer denominator;
};

constexpr fraction ratio(integer n, integer d) { return d < 0 ? fraction{-n, -d} : fraction{n, d}; }

/// The greatest integer not above x.
constexpr integer below(fraction x) {
  integer k = x.numerator / x.denominator;
  if (k * x.denominator > x.numerator) --k;
  return k;
}

/// x rounded by the rule to one of the two integers around it.
constexpr integer round(fraction x, fixproof::rounding rule) {
  const integer low = below(x);
  if (low * x.denominator == x.numerator) return low;
  const integer to_low = x.numerator - low * x.denominator;
  const integer to_high = x.denominator - to_low;
  const bool positive = x.numerator > 0;
  switch (rule) {
    case fixproof::rounding::floor:
      return low;
    case fixproof::rounding::truncate:
      return positive ? low : low + 1;
    case fixproof::rounding::half_up:
      return to_low < to_high ? low : low + 1;
    case fixproof::rounding::half_away:
      if (to_low == to_high) return positive ? low + 1 : low;
      return to_low < to_high ? low : low + 1;
    case fixproof::rounding::half_even:
      if (to_low == to_high) return low % 2 == 0 ? low : low + 1;
      return to_low < to_high ? low : low + 1;
  }
  return 0;
}

/// The integer of `bits` bits, in two's complement, that is x modulo 2^bits.
constexpr integer wrapped(integer x, int bits) {
  const integer count = integer{1} << bits;
  return x - count * below({x + count / 2, count});
}

/// x by the overflow rule; under `trap`, x must be in range.
constexpr integer narrowed(integer x, int bits, fixproof::overflow rule) {
  const integer end = integer{1} << (bits - 1);
  if (rule == fixproof::overflow::wrap) return wrapped(x, bits);
  return x < -end ? -end : x >= end ? integer{end - 1} : x;
}

}  // namespace exact
