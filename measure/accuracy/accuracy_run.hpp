/// @file
/// The errors of every subject of an operation over the same operands.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "measure/accuracy/error_statistics.hpp"
#include "measure/accuracy/subjects.hpp"
#include "player/model_call.hpp"

namespace fixproof::measure {

/// Operands of one operation, one case after the other.
struct OperandSet {
  std::string name;  ///< `uniform`, `log-uniform`, `every angle`, or a scene's
  std::vector<std::uint32_t> words;
};

/// The sets of random operands of `operation`, `cases` each; of angles every one.
std::vector<OperandSet> random_operands(const MeasuredOperation& operation, std::uint64_t seed,
                                        std::uint64_t cases);

/// What a scene gives the operation, thinned out to `cases` at most; empty where it never does.
OperandSet scene_operands(const MeasuredOperation& operation, const std::string& scene,
                          const player::OperandLog& log, std::uint64_t cases);

/// Of one subject over one set.
struct AccuracyRow {
  std::string operation;
  Subject subject;
  std::string operands;
  ErrorStatistics errors;
  std::uint64_t beyond = 0;  ///< cases that have no exact result, or one that does not fit
  std::uint64_t faults = 0;  ///< cases whose exact result fits but that are divide errors
};

/// Adds the error of a result of so many ulps, worked out exactly. It is correct within half an ulp
/// of the exact result.
void add_error(ErrorStatistics& errors, double result, const ExactResult& exact);

/// One row for each subject. Where `stop` ends the run, the rows are of the cases until then.
std::vector<AccuracyRow> measure_errors(const MeasuredOperation& operation, const OperandSet& set,
                                        const std::atomic<bool>& stop);

}  // namespace fixproof::measure
