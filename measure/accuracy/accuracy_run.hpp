/// @file
/// Measures the errors of all subjects of an operation over the same operands.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/check/curve.hpp"
#include "measure/accuracy/error_statistics.hpp"
#include "measure/accuracy/subjects.hpp"
#include "measure/player/model_call.hpp"
#include "support/json.hpp"

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
  std::string operands;  ///< the name of the set
  std::string variant;   ///< a preset of the type, a library, float or double
  std::string alike;     ///< presets with the same results; may be empty
  ErrorStatistics errors;
  std::uint64_t beyond = 0;  ///< cases without an exact result, or with one that does not fit
  std::uint64_t faults = 0;  ///< divide errors although the exact result fits
  std::string worst{};       ///< of a function, the operands of the largest error
  std::optional<check::CurveFigures> curve{};  ///< of a function
};

/// The members that accuracy.hpp lists.
void to_json(support::Json& json, const AccuracyRow& row);

/// Adds the error of `result` ulps, computed exactly. A result within half an ulp counts as
/// correct. Returns the error.
double add_error(ErrorStatistics& errors, const oracle::Integer& result, const ExactResult& exact);
double add_error(ErrorStatistics& errors, double result, const ExactResult& exact);

/// Returns one row for each subject. If `stop` ends the run early, the rows cover the cases so far.
std::vector<AccuracyRow> measure_errors(const MeasuredOperation& operation, const OperandSet& set,
                                        const std::atomic<bool>& stop);

}  // namespace fixproof::measure
