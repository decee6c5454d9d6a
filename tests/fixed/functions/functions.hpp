/// @file
/// The functions of real numbers: what the oracle calls them and how the type computes them.
#pragma once

#include <array>

#include "fixed/fixed.hpp"
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

/// A function and its name.
struct Name {
  Function function;
  const char* name;
};
#define NAME(name) Name{Function::name, #name},
inline constexpr std::array names_of_one{ORACLE_FUNCTIONS_OF_ONE(NAME)};
inline constexpr std::array names_of_two{ORACLE_FUNCTIONS_OF_TWO(NAME)};
#undef NAME

/// A function of stored integers. One function for all of them compiles faster than one for each.
template <class N>
std::int64_t computed(Function function, std::int64_t x_raw, std::int64_t y_raw) {
  using raw = typename N::raw_type;
  const N x = N::from_raw(static_cast<raw>(x_raw));
  const N y = N::from_raw(static_cast<raw>(y_raw));
#define CASE_OF_ONE(name) \
  case Function::name:    \
    return name(x).raw();
#define CASE_OF_TWO(name) \
  case Function::name:    \
    return name(x, y).raw();
  switch (function) {
    ORACLE_FUNCTIONS_OF_ONE(CASE_OF_ONE)
    ORACLE_FUNCTIONS_OF_TWO(CASE_OF_TWO)
  }
#undef CASE_OF_ONE
#undef CASE_OF_TWO
  throw std::invalid_argument("no such function");
}

/// A format at run time, so that what is expected of it is compiled once.
struct Format {
  int bits;
  bool is_signed;
  int fraction_bits;
  std::int64_t (*compute)(Function function, std::int64_t x, std::int64_t y);
  std::int64_t (*whole)(int n);
  /// The quotient of two whole numbers.
  std::int64_t (*quotient)(int n, int d);

  template <class N>
  static Format of() {
    using raw = typename N::raw_type;
    return {8 * sizeof(raw),
            std::is_signed_v<raw>,
            N::fraction_bits,
            computed<N>,
            [](int n) -> std::int64_t { return N(n).raw(); },
            [](int n, int d) -> std::int64_t { return (N(n) / N(d)).raw(); }};
  }

  [[nodiscard]] std::int64_t highest() const {
    return (std::int64_t{1} << (is_signed ? bits - 1 : bits)) - 1;
  }
  [[nodiscard]] std::int64_t lowest() const { return is_signed ? -highest() - 1 : 0; }
  /// The stored integer with the low bits of a word.
  [[nodiscard]] std::int64_t raw_of(std::int64_t word) const {
    const std::int64_t low = word & ((std::int64_t{1} << bits) - 1);
    return low > highest() ? low - (std::int64_t{1} << bits) : low;
  }
};

/// What the functions return outside their domain.
inline std::int64_t outside(const Format& format, Function function, const Integer& x) {
  switch (function) {
    case Function::log2:
    case Function::log:
    case Function::log10:
    case Function::log1p:
      return format.lowest();
    case Function::rsqrt:
    case Function::reciprocal:
    case Function::tan_of_degrees:
    case Function::tan_of_turns:
      return format.highest();
    case Function::pow:
      return x == 0 ? format.highest() : 0;
    default:
      return 0;
  }
}

/// The oracle's result in a type that saturates.
inline std::int64_t expected(const Format& format, Function function, std::int64_t x,
                             std::int64_t y, oracle::Rounding ties) {
  const auto ulps = oracle::nearest(function, x, y, format.fraction_bits, ties);
  if (!ulps) return outside(format, function, x);
  if (*ulps < format.lowest()) return format.lowest();
  return *ulps > format.highest() ? format.highest() : static_cast<std::int64_t>(*ulps);
}

template <class N>
N expected(Function function, N x, N y, oracle::Rounding ties) {
  return N::from_raw(static_cast<typename N::raw_type>(
      expected(Format::of<N>(), function, x.raw(), y.raw(), ties)));
}

}  // namespace functions
