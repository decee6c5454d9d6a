/// @file
/// The steps of the report.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/cli/report/page.hpp"
#include "support/json.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::cli {

struct ReportRequest {
  std::vector<std::string> scenes;  ///< file names
  std::string folder;
  std::uint64_t seed = 1994;
  bool quick = false;  ///< measure only as much as the page needs
};

struct ReportData {
  support::Json parts;                ///< by step name
  std::vector<PagePicture> pictures;  ///< one per scene
  std::string strip;                  ///< SVG of the drift
};

struct ReportStep {
  std::string name;
  std::string command;             ///< command line that writes the same files
  std::vector<std::string> files;  ///< files that run() writes
  /// Measures, writes the files and adds the results.
  /// @return the exit status of the command; files and results are complete if shows_on_page()
  std::function<int(ReportData&)> run;
};

/// Returns the steps in the order in which they run.
/// @param scenes the scenes of the request; they must outlive the steps
std::vector<ReportStep> report_steps(const ReportRequest& request,
                                     const std::vector<xsharp::Scene>& scenes);

/// Whether `--beside` applies: the scene interpolates surfaces in an arithmetic other than double.
bool has_beside(const xsharp::Scene& scene);

/// Whether the report continues after a step with this status. It does if the status is 0, and also
/// if `verify` returns 1, because the page shows how parties differ.
bool shows_on_page(const ReportStep& step, int status);

/// Returns the exit status of a report that stops at a step with this status: 130 after an
/// interrupt, else 2, because status 1 means that parties differ.
int report_status(int status);

/// Returns the last line of output of a report that stops at a step.
std::string stopped_text(const ReportStep& step, int status, std::size_t done, std::size_t all);

}  // namespace fixproof::cli
