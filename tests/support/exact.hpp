/// @file
/// The reference arithmetic of the tests: exact fractions of 128-bit integers.
#pragma once

#include <cstdint>

#include "tests/support/number_rules.hpp"
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
constexpr integer below(const fraction& x) { return below(x.numerator, x.denominator); }

/// x rounded by the rule to one of the two integers around it.
constexpr integer round(const fraction& x, fixproof::rounding rule) {
  return round(x.numerator, x.denominator, rule);
}

/// The integer of `bits` bits, in two's complement, that is x modulo 2^bits.
constexpr integer wrapped(integer x, int bits) {
  const integer count = integer{1} << bits;
  return x - count * below({x + count / 2, count});
}

}  // namespace exact
