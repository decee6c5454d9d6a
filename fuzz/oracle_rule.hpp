/// @file
/// The type's rounding rules in the oracle's words: the parties share no header, so that somebody
/// has to translate.
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
