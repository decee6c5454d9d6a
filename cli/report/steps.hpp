/// @file
/// The commands whose figures the report shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "xsharp/scene.hpp"

namespace fixproof::cli {

/// What was asked for.
struct ReportRequest {
  std::vector<std::string> scenes;  ///< files
  std::string folder;
  std::uint64_t seed = 1994;
  bool quick = false;   ///< as little of everything as makes a page
  bool resume = false;  ///< keep what an earlier run has measured
};

/// One command.
struct ReportStep {
  std::string name;                    ///< of what it measures, in the report's data
  std::vector<std::string> arguments;  ///< of fixproof
  std::vector<std::string> files;      ///< that it writes
};

/// In the order in which they run.
/// @param scenes those of the request, as they were read
std::vector<ReportStep> report_steps(const ReportRequest& request,
                                     const std::vector<xsharp::Scene>& scenes);

/// Whether a scene is drawn beside the exact picture: it is interpolated, and not in double.
bool has_beside(const xsharp::Scene& scene);

/// `fixproof measure --host`, as a shell would be given it.
std::string command_line_of(const ReportStep& step);

/// Whether the page can be made of what a step with that exit status left behind.
bool page_shows(const ReportStep& step, int status);

/// The exit status of a report that such a step ended: 130 where it was stopped, else 2, since 1 is
/// for parties that differ.
int report_status(int status);

/// What is said where a step ended the report.
std::string stopped_text(const ReportStep& step, int status, std::size_t done, std::size_t all);

/// What was done, kept in the folder's data/steps.json.
struct StepRecord {
  std::string name;
  std::string command;
  std::string made_from;  ///< fingerprint() of then
  std::string date;       ///< in UTC, as ISO 8601 writes it
  double seconds = 0;
  int status = 0;
  std::string left;  ///< sum_of_files() of what it left behind
};

/// Another sum where the contents of one of the files are not the same. Empty where one is missing.
std::string sum_of_files(const std::vector<std::string>& files);

/// Stands for the program, the scenes and the processor: another sum where one is not the same.
std::string fingerprint(const std::vector<xsharp::Scene>& scenes, const std::string& processor);

/// A command as it comes back from the records: bytes that are no UTF-8 are replaced.
std::string as_recorded(const std::string& command);

/// Nothing for a file that is not there, or that no report has written.
std::vector<StepRecord> read_records(const std::string& file);
void write_records(const std::string& file, const std::vector<StepRecord>& records);

}  // namespace fixproof::cli
