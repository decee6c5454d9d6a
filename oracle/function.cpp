#include "oracle/function.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <stdexcept>

#include "oracle/real_function.hpp"
#include "oracle/unbounded.hpp"

namespace oracle {
namespace {

using Decimal100 = boost::multiprecision::cpp_bin_float_100;

constexpr unsigned highest_bit = 64;

/// Whether the result for rational operands can be rational but not whole.
bool has_ties(Function function) {
  switch (function) {
    case Function::exp2:
    case Function::sin_of_degrees:
    case Function::cos_of_degrees:
    case Function::cbrt:
    case Function::rsqrt:
    case Function::reciprocal:
    case Function::hypot:
    case Function::pow:
      return true;
    default:
      return false;
  }
}

/// Whether the exponential of x ulps is far beyond 2^64 ulps, or far below one.
bool is_far_out(Function function, const Integer& x, int fraction_bits) {
  switch (function) {
    case Function::exp2:
    case Function::exp:
    case Function::expm1:
    case Function::sinh:
    case Function::cosh:
    case Function::tanh:
      return abs(x) > Integer(300) << fraction_bits;
    default:
      return false;
  }
}

Integer limited(const Integer& x, int fraction_bits) {
  const Integer limit = Integer(300) << fraction_bits;
  return x < 0 ? -limit : limit;
}

Integer nearest_integer(const Decimal100& value, bool may_tie, Rounding ties) {
  const Decimal100 doubled = 2 * value;
  const Integer nearest_half(floor(doubled + 0.5));
  const Decimal100 distance = abs(doubled - Decimal100(nearest_half));
  static const Decimal100 none = ldexp(Decimal100(1), -200);
  if (distance < none && nearest_half % 2 != 0) {
    if (!may_tie) throw std::range_error("a result is too near a tie for 334 bits");
    return rounded(nearest_half, 2, ties);
  }
  return Integer(floor(value + 0.5));
}

}  // namespace

std::optional<Integer> nearest(Function function, const Integer& x, const Integer& y,
                               int fraction_bits, Rounding ties) {
  if (is_far_out(function, x, fraction_bits)) {
    return nearest(function, limited(x, fraction_bits), y, fraction_bits, ties);
  }
  const auto real = [&](const Integer& ulps) { return ldexp(Decimal100(ulps), -fraction_bits); };
  if (!in_domain(function, x, y, fraction_bits)) return std::nullopt;
  const Decimal100 value = ldexp(real_function(function, real(x), real(y)), fraction_bits);
  const Integer highest = Integer(1) << highest_bit;
  if (value >= Decimal100(highest)) return highest;
  if (value <= -Decimal100(highest)) return -highest;
  return nearest_integer(value, has_ties(function), ties);
}

}  // namespace oracle
