/// @file
/// Translates the type's rounding rules to the oracle's, because the parties share no header.
#pragma once

#include "fixed/policy.hpp"
#include "oracle/rule.hpp"

namespace fixproof::fuzz {

constexpr oracle::Rounding oracle_rule(fixed::rounding rule) {
  switch (rule) {
    case fixed::rounding::half_up:
      return oracle::Rounding::half_up;
    case fixed::rounding::half_away:
      return oracle::Rounding::half_away;
    case fixed::rounding::floor:
      return oracle::Rounding::floor;
    case fixed::rounding::truncate:
      break;
  }
  return oracle::Rounding::truncate;
}

}  // namespace fixproof::fuzz
