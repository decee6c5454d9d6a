/// \file
/// The functions of real numbers: what the oracle calls them and how the type computes them.
#pragma once

#include <array>

#include "fixed/angle.hpp"
#include "fixed/exponential.hpp"
#include "fixed/fixed.hpp"
#include "fixed/power.hpp"
#include "fixed/trigonometry.hpp"
#include "oracle/function.hpp"
#include "tests/support/test.hpp"

namespace functions {

using oracle::Function;
using oracle::Integer;

/// Formats of every width, with fraction bits at both ends.
using Formats =
    testing::Types<fixproof::q8_0, fixproof::q4_4, fixproof::q1_7, fixproof::u4_4, fixproof::u0_8,
                   fixproof::q12_4, fixproof::q8_8, fixproof::q1_15, fixproof::u8_8,
                   fixproof::u0_16, fixproof::q32_0, fixproof::q24_8, fixproof::q16_16,
                   fixproof::q8_24, fixproof::q2_30, fixproof::q1_31, fixproof::u24_8,
                   fixproof::u16_16, fixproof::u1_31, fixproof::u0_32,
                   fixproof::number<std::int16_t, 16>, fixproof::number<std::int32_t, 32>>;

template <class N>
struct Named {
  Function function;
  const char* name;
  N (*compute)(N x, N y);
};

template <class N>
constexpr std::array unary{
    Named<N>{Function::exp2, "exp2", [](N x, N) { return exp2(x); }},
    Named<N>{Function::exp, "exp", [](N x, N) { return exp(x); }},
    Named<N>{Function::expm1, "expm1", [](N x, N) { return expm1(x); }},
    Named<N>{Function::log2, "log2", [](N x, N) { return log2(x); }},
    Named<N>{Function::log, "log", [](N x, N) { return log(x); }},
    Named<N>{Function::log10, "log10", [](N x, N) { return log10(x); }},
    Named<N>{Function::log1p, "log1p", [](N x, N) { return log1p(x); }},
    Named<N>{Function::sinh, "sinh", [](N x, N) { return sinh(x); }},
    Named<N>{Function::cosh, "cosh", [](N x, N) { return cosh(x); }},
    Named<N>{Function::tanh, "tanh", [](N x, N) { return tanh(x); }},
    Named<N>{Function::sin, "sin", [](N x, N) { return sin(x); }},
    Named<N>{Function::cos, "cos", [](N x, N) { return cos(x); }},
    Named<N>{Function::tan, "tan", [](N x, N) { return tan(x); }},
    Named<N>{Function::sin_of_degrees, "sin_of_degrees", [](N x, N) { return sin_of_degrees(x); }},
    Named<N>{Function::cos_of_degrees, "cos_of_degrees", [](N x, N) { return cos_of_degrees(x); }},
    Named<N>{Function::tan_of_degrees, "tan_of_degrees", [](N x, N) { return tan_of_degrees(x); }},
    Named<N>{Function::sin_of_turns, "sin_of_turns", [](N x, N) { return sin_of_turns(x); }},
    Named<N>{Function::cos_of_turns, "cos_of_turns", [](N x, N) { return cos_of_turns(x); }},
    Named<N>{Function::tan_of_turns, "tan_of_turns", [](N x, N) { return tan_of_turns(x); }},
    Named<N>{Function::asin, "asin", [](N x, N) { return asin(x); }},
    Named<N>{Function::acos, "acos", [](N x, N) { return acos(x); }},
    Named<N>{Function::atan, "atan", [](N x, N) { return atan(x); }},
    Named<N>{Function::cbrt, "cbrt", [](N x, N) { return cbrt(x); }},
    Named<N>{Function::rsqrt, "rsqrt", [](N x, N) { return rsqrt(x); }},
    Named<N>{Function::reciprocal, "reciprocal", [](N x, N) { return reciprocal(x); }},
};

template <class N>
constexpr std::array binary{
    Named<N>{Function::atan2, "atan2", [](N x, N y) { return atan2(x, y); }},
    Named<N>{Function::hypot, "hypot", [](N x, N y) { return hypot(x, y); }},
    Named<N>{Function::pow, "pow", [](N x, N y) { return pow(x, y); }},
};

/// What the functions return outside their domain.
template <class N>
N outside(Function function, const Integer& x) {
  switch (function) {
    case Function::log2:
    case Function::log:
    case Function::log10:
    case Function::log1p:
      return std::numeric_limits<N>::lowest();
    case Function::rsqrt:
    case Function::reciprocal:
    case Function::tan_of_degrees:
    case Function::tan_of_turns:
      return std::numeric_limits<N>::max();
    case Function::pow:
      return x == 0 ? std::numeric_limits<N>::max() : N();
    default:
      return N();
  }
}

/// The oracle's result in a type that saturates.
template <class N>
N expected(Function function, N x, N y, oracle::Rounding ties) {
  using raw = typename N::raw_type;
  const auto ulps = oracle::nearest(function, x.raw(), y.raw(), N::fraction_bits, ties);
  if (!ulps) return outside<N>(function, x.raw());
  constexpr raw lowest = std::numeric_limits<raw>::min();
  constexpr raw highest = std::numeric_limits<raw>::max();
  if (*ulps < lowest) return N::from_raw(lowest);
  return N::from_raw(*ulps > highest ? highest : static_cast<raw>(*ulps));
}

}  // namespace functions
