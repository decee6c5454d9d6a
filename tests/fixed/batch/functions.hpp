/// @file
/// The functions of fixed/batch/functions.hpp next to those of one number.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "fixed/batch/functions.hpp"
#include "fixed/fixed.hpp"
#include "oracle/function_names.hpp"

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

#define OF_ONE(function)                                       \
  pair_of<N>(                                                  \
      #function, [](N x, N) { return fixproof::function(x); }, \
      [](const auto& x, const auto&, auto& out, auto use) { batch::function(x, out, use); }),
#define OF_TWO(function)                                            \
  pair_of<N>(                                                       \
      #function, [](N x, N y) { return fixproof::function(x, y); }, \
      [](const auto& x, const auto& y, auto& out, auto use) { batch::function(x, y, out, use); }),
template <class N>
inline constexpr std::array all_functions{ORACLE_SPAN_FUNCTIONS_OF_ONE(OF_ONE)
                                              ORACLE_SPAN_FUNCTIONS_OF_TWO(OF_TWO)};
#undef OF_ONE
#undef OF_TWO

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
