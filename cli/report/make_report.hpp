/// @file
/// Measures everything that the report shows and writes the page and its data.
#pragma once

#include "cli/report/steps.hpp"

namespace fixproof::cli {

/// Prints each step and its time to standard output.
/// @return the exit status: 0, 1 if parties differ, or, without a page, 130 after an interrupt and
/// 2
///         if a measurement breaks its own rule
/// @throws UsageError, xsharp::SceneError or std::runtime_error for a file that cannot be read or
///         written
int make_report(const ReportRequest& request);

}  // namespace fixproof::cli
