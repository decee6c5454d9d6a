#include "oracle/tie.hpp"

#include <algorithm>
#include <cstddef>

namespace oracle {
namespace {

Integer two_to(std::size_t exponent) { return Integer(1) << exponent; }

/// Whether root^exponent = power. @pre root and power are odd and positive
bool is_power(const Integer& root, const Integer& exponent, const Integer& power) {
  if (root == 1 || exponent == 0) return power == 1;
  Integer product = 1;
  Integer factors = 0;
  for (; product < power; ++factors) product *= root;
  return product == power && factors == exponent;
}

/// Whether (x / 2^F)^(y / 2^F) = twice / 2^(F + 1), where F is `fraction_bits`.
///
/// Let y / 2^F = p / q in lowest terms, where q is a power of two, and x = 2^n odd. Then the
/// equation is odd^p = twice^q for the odd factors, and p (n - F) = -q (F + 1) for the exponents.
/// As p and q have no common factor, the first holds only if `odd` is the q-th power of an integer
/// whose p-th power is `twice`.
/// @pre x > 0; `twice` is odd and positive
bool is_power_of_reals(const Integer& x, const Integer& y, const Integer& twice,
                       unsigned fraction_bits) {
  if (y == 0) return false;
  const auto n = lsb(x);
  const auto shared = std::min<std::size_t>(lsb(abs(y)), fraction_bits);
  const Integer p = y / two_to(shared);
  const Integer q = two_to(fraction_bits - shared);
  if (p * (Integer(n) - fraction_bits) != -q * (fraction_bits + 1)) return false;
  Integer root = x >> n;
  for (Integer roots = q; roots > 1 && root > 1; roots /= 2) {
    Integer rest;
    root = sqrt(root, rest);
    if (rest != 0) return false;
  }
  return is_power(root, p, twice);
}

/// Whether an angle of some eighths of a turn is twice / 2 ulps.
bool is_eighths(int eighths, const Integer& twice, std::size_t fraction_bits) {
  return 4 * abs(twice) == eighths * two_to(fraction_bits);
}

/// Eighths of a turn in the angle of (x, y), if that is a multiple; else 0.
int eighths_of(const Integer& y, const Integer& x) {
  if (y == 0) return x < 0 ? 4 : 0;
  if (x == 0) return 2;
  if (abs(x) != abs(y)) return 0;
  return x < 0 ? 3 : 1;
}

}  // namespace

bool is_tie(Function function, const Integer& x, const Integer& y, const Integer& twice,
            int fraction_bits) {
  const auto bits = static_cast<unsigned>(fraction_bits);
  switch (function) {
    case Function::exp2:
      return twice > 0 && is_power_of_reals(two_to(bits + 1), x, twice, bits);
    case Function::pow:
      // A negative x has a whole exponent, so only the sign differs.
      return x != 0 && is_power_of_reals(abs(x), y, abs(twice), bits);
    // By Niven's theorem, 0, 1/2 and 1 are the only rational sines of a rational number of degrees,
    // except for their signs. Only 1/2 can be a tie, and only in a format of integers.
    case Function::sin_of_degrees:
      return bits == 0 && (abs(x) % 180 == 30 || abs(x) % 180 == 150);
    case Function::cos_of_degrees:
      return bits == 0 && (abs(x) % 180 == 60 || abs(x) % 180 == 120);
    // By the same theorem, only multiples of an eighth of a turn are rational and have a dyadic
    // sine, cosine or tangent, but for a sixth and a twelfth, which are no ties.
    case Function::atan_in_turns:
      return is_eighths(eighths_of(x, two_to(bits)), twice, bits);
    case Function::atan2_in_turns:
      return is_eighths(eighths_of(x, y), twice, bits);
    case Function::asin_in_turns:
      return abs(x) == two_to(bits) && is_eighths(2, twice, bits);
    case Function::acos_in_turns:
      return (x == 0 && is_eighths(2, twice, bits)) ||
             (x == -two_to(bits) && is_eighths(4, twice, bits));
    case Function::rsqrt:
      return twice * twice * x == two_to(3 * bits + 2);
    case Function::reciprocal:
      return twice * x == two_to(2 * bits + 1);
    // Ties of cbrt and hypot: a power of `twice`, which is odd, would have to be a multiple of 4.
    default:
      return false;
  }
}

}  // namespace oracle
