/// @file
/// Runs what the report shows and writes the page and its data.
#pragma once

#include "cli/report/steps.hpp"

namespace fixproof::cli {

/// Says on standard output how far it is.
/// @return the exit status: 1 where parties differ, 130 where it was stopped and 2 where a step did
///         not succeed, both without a page
/// @throws UsageError, xsharp::SceneError or std::runtime_error for what cannot be read or written
int make_report(const ReportRequest& request);

}  // namespace fixproof::cli
