/// @file
/// The errors of the functions of fixed/: exponentials, logarithms, angles, roots, powers,
/// remainders and the quotient of a product.
#pragma once

#include <optional>

#include "measure/accuracy/format_accuracy.hpp"
#include "measure/measure.hpp"

namespace fixproof::measure {

/// Measures one function or all over the cases of `fixproof gen`, in the request's format: the
/// type, float and double of the C library, whose results lrint rounds to words, and in 16.16 the
/// libraries that have the function.
/// @throws support::UsageError if fixed/formats.hpp does not name the format, it has 64 bits or
///         lacks the function, and for a name that is not a function's
std::optional<FormatAccuracyResult> measure_function_accuracy(const MeasureRequest& request,
                                                              MeasureProgress& progress);

}  // namespace fixproof::measure
