/// @file
/// The tables of `fixproof measure`.
#pragma once

#include <cstdint>
#include <string>

#include "measure/accuracy/accuracy.hpp"
#include "measure/clocks/clocks.hpp"
#include "measure/host/host.hpp"
#include "measure/stepping/stepping.hpp"

namespace fixproof::cli {

std::string text_of(const measure::AccuracyResult& result);
std::string text_of(const measure::ClockResult& result);
std::string text_of(const measure::HostResult& result);
std::string text_of(const measure::SteppingResult& result);

/// A claim, its verdict, and one line per figure.
std::string text_of(const measure::Claim& claim);

/// `seed 1994, g++ 12.2.0`
std::string made_by(std::uint64_t seed);

/// One line for each library that is not built in.
std::string missing_libraries();

/// An error in ulps.
std::string error_text(double x, bool with_sign = false);

/// The largest of some errors. It is truncated, so that an error below 1 is not shown as 1.
std::string largest_text(double x);

/// A share of 0 ... 1 in percent. Only a share of 1 is shown as 100 %.
std::string share_text(double x);

/// A count or a mean of counts; two numbers where Intel's tables give a range.
std::string between(double min, double max, int decimals);

/// Least, median and spread of a time, as three columns.
std::string columns_of(const measure::Times& times);

}  // namespace fixproof::cli
