/// @file
/// Runs one measurement for `fixproof measure` and the report.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measure/host/host_times.hpp"
#include "measure/measure.hpp"
#include "measure/stepping/stepping.hpp"
#include "support/interrupt.hpp"
#include "support/json.hpp"

namespace fixproof::cli {

template <class Result>
using Measurement = std::optional<Result> (*)(const measure::MeasureRequest&,
                                              measure::MeasureProgress&);

template <class Result>
struct Measured {
  std::optional<Result> result;
  int status = 0;                   ///< exit status: 0, 1 if there are `errors`, 130 if interrupted
  std::vector<std::string> errors;  ///< rules and bounds that the measured arithmetic breaks
};

/// The members of --json.
template <class Result>
support::Json json_of(const Measured<Result>& measured) {
  support::Json json = support::Json::object();
  if (measured.result) json = *measured.result;
  json["errors"] = measured.errors;
  return json;
}

/// Returns one line per error beyond its derived bound. Only stepped values have such bounds.
std::vector<std::string> broken_bounds(const measure::SteppingResult& result);
template <class Result>
std::vector<std::string> broken_bounds(const Result& /*result*/) {
  return {};
}

template <class Result>
Measured<Result> run_measurement(Measurement<Result> measure,
                                 const measure::MeasureRequest& request,
                                 measure::MeasureProgress& progress) {
  Measured<Result> measured;
  try {
    measured.result = measure(request, progress);
    if (!measured.result) measured.status = support::interrupted_status;
  } catch (const measure::WrongContender& wrong) {
    measured.errors = {wrong.what()};
  }
  progress.end();
  if (measured.result) measured.errors = broken_bounds(*measured.result);
  if (!measured.errors.empty()) measured.status = 1;
  return measured;
}

}  // namespace fixproof::cli
