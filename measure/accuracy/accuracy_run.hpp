/// @file
/// Measures the errors of all subjects of an operation over the same operands.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "measure/accuracy/error_statistics.hpp"
#include "measure/accuracy/subjects.hpp"
#include "player/model_call.hpp"

namespace fixproof::measure {

/// The operands of one operation, case by case.
struct OperandSet {
  std::string name;  ///< `uniform`, `log-uniform`, `every angle` or the name of a scene
  std::vector<std::uint32_t> words;
};

/// The sets of random operands, `cases` each. For angles, one set of all angles.
std::vector<OperandSet> random_operands(const MeasuredOperation& operation, std::uint64_t seed,
                                        std::uint64_t cases);

/// A random sample of at most `cases` operands from a scene; empty if the scene never calls the
/// operation.
OperandSet scene_operands(const MeasuredOperation& operation, const std::string& scene,
                          const player::OperandLog& log, std::uint64_t cases);

struct AccuracyRow {
  std::string operation;
  Subject subject;
  std::string operands;
  ErrorStatistics errors;
  std::uint64_t beyond = 0;  ///< cases without an exact result, or with one that does not fit
  std::uint64_t faults = 0;  ///< divide errors although the exact result fits
};

/// Adds the error of `result`, which is in ulps, computed exactly. A result within half an ulp
/// counts as correct.
void add_error(ErrorStatistics& errors, double result, const ExactResult& exact);

/// Returns one row for each subject. If `stop` ends the run early, the rows cover the cases so far.
std::vector<AccuracyRow> measure_errors(const MeasuredOperation& operation, const OperandSet& set,
                                        const std::atomic<bool>& stop);

}  // namespace fixproof::measure
