/// @file
/// Tables of `fixproof measure`.
#pragma once

#include <cstdint>
#include <string>

#include "measure/accuracy/accuracy.hpp"
#include "measure/accuracy/function_accuracy.hpp"
#include "measure/clocks/clocks.hpp"
#include "measure/host/host.hpp"
#include "measure/stepping/stepping.hpp"

namespace fixproof::cli {

std::string text_of(const measure::AccuracyResult& result);
std::string text_of(const measure::FormatAccuracyResult& result);
std::string text_of(const measure::ClockResult& result);
std::string text_of(const measure::HostResult& result);
std::string text_of(const measure::SteppingResult& result);

std::string text_of(const measure::Claim& claim);

/// Formats the seed and the compiler, as in `seed 1994, g++ 12.2.0`.
std::string made_by(std::uint64_t seed);

/// Returns one line per library that this program was built without.
std::string missing_libraries();

/// Formats an error in ulps.
std::string error_text(double x, bool with_sign = false);

/// Formats a maximum error. It truncates, so that an error below 1 never appears as 1.
std::string largest_text(double x);

/// Formats a share from 0 to 1 in percent. Only a share of 1 appears as 100 %.
std::string share_text(double x);

/// Formats a count or a mean of counts, as a range if Intel's tables give one.
std::string between(double min, double max, int decimals);

/// Formats the minimum, the median and the spread of a time as three columns.
std::string columns_of(const measure::Times& times);

}  // namespace fixproof::cli
