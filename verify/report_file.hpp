/// @file
/// Reads reports from files.
#pragma once

#include <string>

#include "verify/report.hpp"
#include "verify/report_json.hpp"

namespace fixproof::verify {

/// Reads a report. This build must have all of its parties.
/// @throws std::runtime_error naming the file and the reason
Report read_report(const std::string& path);

}  // namespace fixproof::verify
