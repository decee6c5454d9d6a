/// \file
/// The functions of batch/functions.hpp next to those of one number.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "batch/functions.hpp"
#include "fixed/fixed.hpp"

namespace batch_test {

using namespace fixproof;

/// All paths. The library replaces those that the processor lacks.
inline constexpr std::array every_path{batch::path::portable, batch::path::neon, batch::path::avx2,
                                       batch::path::avx512};

template <class N>
using Numbers = std::vector<N>;

template <class N>
struct BatchFunction {
  const char* name;
  N (*one)(N x, N y);
  void (*many)(const Numbers<N>& x, const Numbers<N>& y, Numbers<N>& out, batch::path use);
};

template <class N>
constexpr BatchFunction<N> pair_of(const char* name, decltype(BatchFunction<N>::one) one,
                                   decltype(BatchFunction<N>::many) many) {
  return {name, one, many};
}

#define UNARY(function)                                        \
  pair_of<N>(                                                  \
      #function, [](N x, N) { return fixproof::function(x); }, \
      [](const auto& x, const auto&, auto& out, auto use) { batch::function(x, out, use); })
#define BINARY(function)                                            \
  pair_of<N>(                                                       \
      #function, [](N x, N y) { return fixproof::function(x, y); }, \
      [](const auto& x, const auto& y, auto& out, auto use) { batch::function(x, y, out, use); })

template <class N>
inline constexpr std::array all_functions{
    UNARY(exp),
    UNARY(exp2),
    UNARY(expm1),
    UNARY(log),
    UNARY(log2),
    UNARY(log10),
    UNARY(log1p),
    UNARY(sinh),
    UNARY(cosh),
    UNARY(tanh),
    UNARY(sin),
    UNARY(cos),
    UNARY(tan),
    UNARY(sin_of_degrees),
    UNARY(cos_of_degrees),
    UNARY(tan_of_degrees),
    UNARY(asin),
    UNARY(sin_of_turns),
    UNARY(cos_of_turns),
    UNARY(tan_of_turns),
    UNARY(acos),
    UNARY(atan),
    UNARY(cbrt),
    UNARY(rsqrt),
    UNARY(reciprocal),
    BINARY(atan2),
    BINARY(hypot),
    BINARY(pow),
};
#undef UNARY
#undef BINARY

/// The ends of the range, small numbers, and words with any number of leading zeros.
template <class N>
Numbers<N> operands(std::size_t count, unsigned seed) {
  using raw = typename N::raw_type;
  std::mt19937 random(seed);
  Numbers<N> all{N(), std::numeric_limits<N>::lowest(), std::numeric_limits<N>::max()};
  while (all.size() < count) {
    const std::uint32_t word = static_cast<std::uint32_t>(random()) >> random() % 32;
    all.push_back(N::from_raw(static_cast<raw>(random() % 2 == 0 ? word : 0 - word)));
  }
  return all;
}

}  // namespace batch_test
