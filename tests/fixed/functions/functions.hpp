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
#include "oracle/function_names.hpp"
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

#define OF_ONE(name) Named<N>{Function::name, #name, [](N x, N) { return name(x); }},
#define OF_TWO(name) Named<N>{Function::name, #name, [](N x, N y) { return name(x, y); }},
template <class N>
constexpr std::array unary{ORACLE_FUNCTIONS_OF_ONE(OF_ONE)};
template <class N>
constexpr std::array binary{ORACLE_FUNCTIONS_OF_TWO(OF_TWO)};
#undef OF_ONE
#undef OF_TWO

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
