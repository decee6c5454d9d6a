/// @file
/// The commands whose figures the report shows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "xsharp/scene.hpp"

namespace fixproof {

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
std::vector<ReportStep> report_steps(const ReportRequest& request);

/// `fixproof measure --host`, as a shell would be given it.
std::string command_line_of(const ReportStep& step);

/// What was done, kept in the folder's data/steps.json.
struct StepRecord {
  std::string name;
  std::string command;
  std::string made_from;  ///< fingerprint() of then
  std::string date;       ///< in UTC, as ISO 8601 writes it
  double seconds = 0;
  int status = 0;
};

/// Stands for the program and the scenes: another sum where either is not the same.
std::string fingerprint(const std::vector<xsharp::Scene>& scenes);

/// Nothing for a file that is not there, or that no report has written.
std::vector<StepRecord> read_records(const std::string& file);
void write_records(const std::string& file, const std::vector<StepRecord>& records);

}  // namespace fixproof
