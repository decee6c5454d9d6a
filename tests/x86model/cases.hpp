/// @file
/// Operands for tests of whole routines, and iteration over all programs.
#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

#include "x86model/call.hpp"

namespace x86model::test {

inline constexpr std::array<std::uint32_t, 22> boundary{
    0,          1,          2,          0x7FFF,     0x8000,     0x8001,     0xFFFF,     0x10000,
    0x10001,    0x18000,    0x28000,    0x7FFF0000, 0x7FFFFFFF, 0x80000000, 0x80000001, 0x80010000,
    0xFFFF0000, 0xFFFF8000, 0xFFFF7FFF, 0xFFFFFFFF, 0x55555555, 0xAAAAAAAA};

inline constexpr std::array<Build, 6> builds{
    Build{.mul_rounding = true, .div_rounding = true},
    Build{.mul_rounding = true, .div_rounding = false},
    Build{.mul_rounding = false, .div_rounding = true},
    Build{.mul_rounding = false, .div_rounding = false},
    Build{.chapter_52 = true},
    Build{.repaired = true},
};

/// Chapter 52 has only 386 code, and only 8088 code has a repaired form.
constexpr bool is_for(const Build& build, Target target) {
  return target == Target::i386 ? !build.repaired : !build.chapter_52;
}

/// Operands of `routine`, case by case: all pairs of boundary values, angles in every quadrant, and
/// matrices of boundary values and of random words.
inline std::vector<std::uint32_t> cases(Routine routine) {
  std::vector<std::uint32_t> words;
  const auto in = static_cast<std::size_t>(arity(routine).in);
  if (routine == Routine::cossin) {
    for (std::uint32_t angle = 0; angle < 0x10000; angle += 97) words.push_back(angle);
    for (const std::uint32_t angle :
         {0U, 900U, 1800U, 2700U, 3600U, 3601U, 0xFFFFU, 0x8000U, 0x7FFFU}) {
      words.push_back(angle);
    }
  } else if (in == 2) {
    for (const std::uint32_t a : boundary) {
      for (const std::uint32_t b : boundary) words.insert(words.end(), {a, b});
    }
  } else {
    std::mt19937 random(54);
    for (int i = 0; i < 200; ++i) {
      for (std::size_t k = 0; k < in; ++k) {
        const auto bits = static_cast<std::uint32_t>(random());
        words.push_back(i % 2 == 0 ? bits : boundary.at(bits % boundary.size()));
      }
    }
  }
  return words;
}

/// Calls `visit.operator()<routine, target>()` for every routine on every processor.
template <class Visit>
void each_routine(Visit visit) {
  const auto both = [&]<Routine routine>() {
    visit.template operator()<routine, Target::i386>();
    visit.template operator()<routine, Target::i8088>();
  };
  both.template operator()<Routine::mul>();
  both.template operator()<Routine::div>();
  both.template operator()<Routine::cossin>();
  both.template operator()<Routine::xformvec>();
  both.template operator()<Routine::concat>();
}

}  // namespace x86model::test
