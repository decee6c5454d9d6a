/// @file
/// The errors of products, quotients and square roots in a format.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "measure/accuracy/accuracy_run.hpp"
#include "measure/measure.hpp"
#include "support/json.hpp"
#include "verify/cases/format.hpp"

namespace fixproof::measure {

struct FormatAccuracyResult {
  std::uint64_t seed = 0;
  cases::Format format;
  std::vector<AccuracyRow> rows;
  std::string function{};  ///< of measure_function_accuracy(), or `all`
};

/// @throws support::UsageError if fixed/formats.hpp does not name the format
void require_named(const cases::Format& format);

/// Measures the type under each rounding rule, and float and double, whose results are not rounded
/// to words. Operands are log-uniform or uniform; uniform factors are small enough for every
/// product to fit.
/// @throws support::UsageError if fixed/formats.hpp does not name the request's format
std::optional<FormatAccuracyResult> measure_format_accuracy(const MeasureRequest& request,
                                                            MeasureProgress& progress);

/// As that of AccuracyResult, with the name of the `format`, but without scenes, libraries and
/// pixels. Rows of functions also have `worst`, the operands of the largest error; `mean_size`, the
/// mean of the errors' magnitudes; and `order` and `symmetry`: {pairs, wrong, first}.
void to_json(support::Json& json, const FormatAccuracyResult& result);

}  // namespace fixproof::measure
