/// @file
/// The errors of every operation under every variant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "measure/accuracy/accuracy_run.hpp"
#include "measure/accuracy/pixel_error.hpp"
#include "measure/measure.hpp"
#include "support/json.hpp"

namespace fixproof::measure {

struct AccuracyResult {
  std::uint64_t seed = 0;
  std::vector<std::string> scenes;  ///< the scenes whose operands were recorded
  std::vector<AccuracyRow> rows;
  PageProjection page;
  std::uint64_t points = 0;  ///< per octave of distance
  std::vector<PixelErrors> pixels;
};

std::optional<AccuracyResult> measure_accuracy(const MeasureRequest& request,
                                               MeasureProgress& progress);

/// Errors are in ulps of 16.16, but those of points are in pixels. `correct` is the share, 0 ... 1,
/// of results within half an ulp.
///
///     made        {command, seed, compiler, date}
///     scenes      the scenes whose operands were recorded
///     libfixmath, FreeType: whether each is built in
///     accuracy    a list of {operation, operands, variant; alike: endings of presets that return
///                 the same; cases, left_out, faults; max, mean, mean_error: the standard error of
///                 the mean of random cases, rms / sqrt(cases); rms, correct; histogram: {span,
///                 counts}}
///     pixels      {constant, half_width; variants: a list of {variant; safe_from: the distance
///                 from which no point is half a pixel off; octaves: a list of {from, to, max,
///                 mean, half_a_pixel: the share of points half a pixel off or more}}}
void to_json(support::Json& json, const AccuracyResult& result);

}  // namespace fixproof::measure
