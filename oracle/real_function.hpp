/// The functions for any floating-point type.
#pragma once

#include <cmath>
#include <stdexcept>

#include "oracle/function.hpp"

namespace oracle {

/// Whether the function has a value at x / 2^fraction_bits, or at that and y / 2^fraction_bits.
template <class Int>
bool in_domain(Function function, const Int& x, const Int& y, int fraction_bits) {
  const Int one = Int(1) << fraction_bits;
  const auto is_odd_multiple = [&x](const Int& quarter) {
    return x % quarter == 0 && (x / quarter) % 2 != 0;
  };
  switch (function) {
    case Function::log2:
    case Function::log:
    case Function::log10:
    case Function::rsqrt:
      return x > 0;
    case Function::log1p:
      return x > -one;
    case Function::tan_of_degrees:
      return !is_odd_multiple(90 * one);
    case Function::tan_of_turns:
      return fraction_bits < 2 || !is_odd_multiple(one / 4);
    case Function::asin:
    case Function::acos:
    case Function::asin_in_degrees:
    case Function::acos_in_degrees:
    case Function::asin_in_turns:
    case Function::acos_in_turns:
      return x >= -one && x <= one;
    case Function::acosh:
      return x >= one;
    case Function::atanh:
      return x > -one && x < one;
    case Function::reciprocal:
      return x != 0;
    case Function::pow:
      return x > 0 || y == 0 || (x == 0 && y > 0) || (x < 0 && y % one == 0);
    default:
      return true;
  }
}

/// The function in the arithmetic of Real. An angle in degrees or turns is reduced to a turn first.
template <class Real>
Real real_function(Function function, const Real& x, const Real& y) {
  using std::acos, std::acosh, std::asin, std::asinh, std::atan, std::atan2, std::atanh, std::cbrt,
      std::cos, std::cosh, std::exp, std::expm1, std::fmod, std::log, std::log1p, std::pow,
      std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
  static const Real pi = acos(Real(-1));
  const auto degrees = [&] { return fmod(x, Real(360)) * pi / 180; };
  const auto angle = [&] { return x == 0 && y == 0 ? Real(0) : Real(atan2(x, y)); };
  const auto in_degrees = [&](const Real& radians) { return Real(radians * 180 / pi); };
  const auto in_turns = [&](const Real& radians) { return Real(radians / (2 * pi)); };
  const auto turns = [&] { return fmod(x, Real(1)) * 2 * pi; };
  switch (function) {
    case Function::exp2:
      return pow(Real(2), x);
    case Function::exp:
      return exp(x);
    case Function::expm1:
      return expm1(x);
    case Function::log2:
      return log(x) / log(Real(2));
    case Function::log:
      return log(x);
    case Function::log10:
      return log(x) / log(Real(10));
    case Function::log1p:
      return log1p(x);
    case Function::sinh:
      return sinh(x);
    case Function::cosh:
      return cosh(x);
    case Function::tanh:
      return tanh(x);
    case Function::sin:
      return sin(x);
    case Function::cos:
      return cos(x);
    case Function::tan:
      return tan(x);
    case Function::sin_of_degrees:
      return sin(degrees());
    case Function::cos_of_degrees:
      return cos(degrees());
    case Function::tan_of_degrees:
      return tan(degrees());
    case Function::sin_of_turns:
      return sin(turns());
    case Function::cos_of_turns:
      return cos(turns());
    case Function::tan_of_turns:
      return tan(turns());
    case Function::asin:
      return asin(x);
    case Function::acos:
      return acos(x);
    case Function::atan:
      return atan(x);
    case Function::cbrt:
      return cbrt(x);
    case Function::rsqrt:
      return 1 / sqrt(x);
    case Function::reciprocal:
      return 1 / x;
    case Function::atan2:
      return angle();
    case Function::atan2_in_degrees:
      return in_degrees(angle());
    case Function::atan2_in_turns:
      return in_turns(angle());
    case Function::exp10:
      return pow(Real(10), x);
    case Function::asinh:
      return asinh(x);
    case Function::acosh:
      return acosh(x);
    case Function::atanh:
      return atanh(x);
    case Function::asin_in_degrees:
      return in_degrees(asin(x));
    case Function::acos_in_degrees:
      return in_degrees(acos(x));
    case Function::atan_in_degrees:
      return in_degrees(atan(x));
    case Function::asin_in_turns:
      return in_turns(asin(x));
    case Function::acos_in_turns:
      return in_turns(acos(x));
    case Function::atan_in_turns:
      return in_turns(atan(x));
    case Function::hypot:
      return sqrt(x * x + y * y);
    case Function::pow:
      return pow(x, y);
  }
  throw std::invalid_argument("no such function");
}

}  // namespace oracle
