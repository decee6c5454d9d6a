/// @file
/// Translates the type's rounding rules to the oracle's, because the parties share no header.
#pragma once

#include <stdexcept>

#include "fixed/policy.hpp"
#include "oracle/rule.hpp"

namespace fixproof::fuzz {

constexpr oracle::Rounding oracle_rule(fixproof::rounding rule) {
  switch (rule) {
    case fixproof::rounding::half_up:
      return oracle::Rounding::half_up;
    case fixproof::rounding::half_away:
      return oracle::Rounding::half_away;
    case fixproof::rounding::floor:
      return oracle::Rounding::floor;
    case fixproof::rounding::half_even:
      return oracle::Rounding::half_even;
    case fixproof::rounding::ceiling:
      return oracle::Rounding::ceiling;
    case fixproof::rounding::truncate:
      return oracle::Rounding::truncate;
    case fixproof::rounding::nearest:
      break;
  }
  throw std::invalid_argument("a rule for functions alone");
}

}  // namespace fixproof::fuzz
