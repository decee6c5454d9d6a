#include "oracle/function.hpp"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <stdexcept>

#include "oracle/format.hpp"
#include "oracle/real_function.hpp"
#include "oracle/tie.hpp"

namespace oracle {
namespace {

using boost::multiprecision::cpp_bin_float;

/// 334 bits, and twice as many.
using Decimal100 = boost::multiprecision::cpp_bin_float_100;
using Decimal200 = boost::multiprecision::number<cpp_bin_float<200>>;

/// Whether the exponential of x ulps is far beyond 2^64 ulps, or far below one.
bool is_far_out(Function function, const Integer& x, int fraction_bits) {
  switch (function) {
    case Function::exp2:
    case Function::exp:
    case Function::exp10:
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

/// The function in ulps; empty outside the domain.
template <class Real>
std::optional<Real> value_in_ulps(Function function, const Integer& x, const Integer& y,
                                  int fraction_bits) {
  if (is_far_out(function, x, fraction_bits)) {
    return value_in_ulps<Real>(function, limited(x, fraction_bits), y, fraction_bits);
  }
  if (!in_domain(function, x, y, fraction_bits)) return std::nullopt;
  const auto real = [&](const Integer& ulps) { return ldexp(Real(ulps), -fraction_bits); };
  const Real value = ldexp(real_function(function, real(x), real(y)), fraction_bits);
  static const Real highest = ldexp(Real(1), 64);
  if (abs(value) < highest) return value;
  return value < 0 ? -highest : highest;
}

/// Twice the value if that is within 2^-200 of an integer.
template <class Real>
std::optional<Integer> twice_if_whole(const Real& value) {
  const Real doubled = 2 * value;
  const Real whole = floor(doubled + 0.5);
  static const Real none = ldexp(Real(1), -200);
  if (abs(doubled - whole) >= none) return std::nullopt;
  return Integer(whole);
}

#define ORACLE_NAME(name) std::string_view(#name),
constexpr std::array names{ORACLE_FUNCTIONS(ORACLE_NAME)};
#undef ORACLE_NAME

/// Whether 334 bits are enough: large angles and powers lose as many bits as the operands have.
bool is_short(const Integer& x, const Integer& y, int fraction_bits) {
  const Integer limit = Integer(1) << 33;
  return fraction_bits <= 32 && abs(x) <= limit && abs(y) <= limit;
}

template <class Real>
std::optional<Ratio> ratio_of(Function function, const Integer& x, const Integer& y,
                              int fraction_bits) {
  const auto value = value_in_ulps<Real>(function, x, y, fraction_bits);
  if (!value) return std::nullopt;
  const Integer one = Integer(1) << fraction_bits;
  const auto twice = twice_if_whole(*value);
  if (twice && (*twice % 2 == 0 || is_tie(function, x, y, *twice, fraction_bits))) {
    return Ratio{*twice, 2 * one};
  }
  constexpr int precision = 220;
  return Ratio{Integer(floor(ldexp(*value, precision))), one << precision};
}

template <class Real>
std::optional<Integer> nearest_of(Function function, const Integer& x, const Integer& y,
                                  int fraction_bits, Rounding ties) {
  const auto value = value_in_ulps<Real>(function, x, y, fraction_bits);
  if (!value) return std::nullopt;
  const auto twice = twice_if_whole(*value);
  if (!twice) return Integer(floor(*value + 0.5));
  if (*twice % 2 != 0 && !is_tie(function, x, y, *twice, fraction_bits)) {
    throw std::range_error("a result is too near a tie to decide");
  }
  return rounded(*twice, 2, ties);
}

}  // namespace

std::optional<Function> function_named(std::string_view name) {
  const auto* const found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Function>(found - names.begin());
}

std::optional<Ratio> function_value(Function function, const Integer& x, const Integer& y,
                                    int fraction_bits) {
  return is_short(x, y, fraction_bits) ? ratio_of<Decimal100>(function, x, y, fraction_bits)
                                       : ratio_of<Decimal200>(function, x, y, fraction_bits);
}

std::optional<Integer> nearest(Function function, const Integer& x, const Integer& y,
                               int fraction_bits, Rounding ties) {
  return is_short(x, y, fraction_bits)
             ? nearest_of<Decimal100>(function, x, y, fraction_bits, ties)
             : nearest_of<Decimal200>(function, x, y, fraction_bits, ties);
}

}  // namespace oracle
