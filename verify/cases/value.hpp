/// @file
/// Exact values in units of a format.
#pragma once

#include <cstdint>

#include "oracle/decimal.hpp"
#include "verify/cases/format.hpp"

namespace fixproof::cases {

/// Returns the value of one unit.
oracle::Ratio unit_of(const Format& format);
/// Returns the value of a number of units.
oracle::Ratio value_of(const oracle::Integer& units, const Format& format);
/// Returns the value of a word.
oracle::Ratio value_of(std::uint64_t word, const Format& format);
/// Returns a value in units, rounded once.
oracle::Integer to_ulps(const oracle::Ratio& value, oracle::Rounding rule, const Format& format);

}  // namespace fixproof::cases
