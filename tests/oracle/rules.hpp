#pragma once

#include <array>

#include "oracle/rule.hpp"

/// Lists of the rules' values, for tests of all rules.
namespace oracle::test {

inline constexpr std::array kRoundings{Rounding::half_up,  Rounding::half_away, Rounding::floor,
                                       Rounding::truncate, Rounding::half_even, Rounding::ceiling};

inline constexpr std::array kDivideRules{DivideRule::i386_rounded, DivideRule::i386_unrounded,
                                         DivideRule::i8088_rounded, DivideRule::i8088_unrounded};

}  // namespace oracle::test
