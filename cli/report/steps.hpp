/// @file
/// The measurements of the report, in the order in which they run.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cli/report/page.hpp"
#include "support/json.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::cli {

/// The options of `fixproof report`.
struct ReportRequest {
  std::vector<std::string> scenes;  ///< files
  std::string folder;
  std::uint64_t seed = 1994;
  bool quick = false;  ///< measure as little as a page needs
};

/// The results of the steps that have run.
struct ReportData {
  support::Json parts;                ///< by the name of the step
  std::vector<PagePicture> pictures;  ///< one for each scene
  std::string strip;                  ///< the SVG of the drift
};

/// One measurement.
struct ReportStep {
  std::string name;
  std::string command;             ///< the command line that writes the same files
  std::vector<std::string> files;  ///< the files that run() writes
  /// Measures, writes the files and adds the results.
  /// @return the exit status of the command; files and results are complete if shows_on_page()
  std::function<int(ReportData&)> run;
};

/// @param scenes the scenes of the request, as read; they must outlive the steps
std::vector<ReportStep> report_steps(const ReportRequest& request,
                                     const std::vector<xsharp::Scene>& scenes);

/// Whether `--beside` applies to a scene: it interpolates surfaces, and not in double.
bool has_beside(const xsharp::Scene& scene);

/// Whether the page can be made after a step with this status: `verify` has status 1 if parties
/// differ, and the page shows the difference.
bool shows_on_page(const ReportStep& step, int status);

/// The exit status of a report that ends at a step with this status: 130 after an interrupt, else
/// 2, because status 1 means that parties differ.
int report_status(int status);

/// The last line of a report that ends at a step.
std::string stopped_text(const ReportStep& step, int status, std::size_t done, std::size_t all);

}  // namespace fixproof::cli
