/// @file
/// Runs all measurements of the report and writes the page and its data.
#pragma once

#include "app/cli/report/steps.hpp"

namespace fixproof::cli {

/// Makes the report. Prints each step and its duration to standard output.
/// @return the exit status: 0, or 1 if parties differ; without a page, 130 after an interrupt and 2
///         if a measurement breaks its own rule
/// @throws UsageError, xsharp::SceneError or std::runtime_error if a file cannot be read or written
int make_report(const ReportRequest& request);

}  // namespace fixproof::cli
