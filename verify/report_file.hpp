/// @file
/// Reports in files.
#pragma once

#include <string>

#include "verify/report.hpp"
#include "verify/report_json.hpp"

namespace fixproof::verify {

/// The report in a file, its parties all of this build.
/// @throws std::runtime_error naming the file and the reason
Report read_report(const std::string& path);

}  // namespace fixproof::verify
