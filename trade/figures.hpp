/// @file
/// Errors as the tables print them.
#pragma once

#include <string>

namespace fixproof::trade {

/// An error in units of the last place.
std::string error_text(double x, bool with_sign = false);

/// The largest of some errors, toward zero: what stays below 1 is not to be shown as 1.
std::string largest_text(double x);

/// A share of 0 ... 1 in percent. 100 % is said of all cases alone.
std::string share_text(double x);

/// A count or a mean of counts; two numbers where Intel's tables leave a range.
std::string between(double min, double max, int decimals);

}  // namespace fixproof::trade
