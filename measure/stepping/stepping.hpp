/// @file
/// Measures the errors and the cost of values that are stepped across spans.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "measure/clocks/claims.hpp"
#include "measure/measure.hpp"
#include "measure/stepping/stepping_clocks.hpp"
#include "measure/stepping/stepping_run.hpp"
#include "measure/stepping/stepping_times.hpp"
#include "support/json.hpp"

namespace fixproof::measure {

struct SteppingResult {
  std::uint64_t seed = 0;
  std::uint64_t spans = 0;   ///< per length
  std::uint64_t rounds = 0;  ///< rounds of timing
  std::vector<SteppingRow> rows;
  std::vector<SetupClocks> setups;
  std::vector<PixelCost> pixels;
  std::vector<SteppingTimes> times;
  std::vector<Claim> claims;
};

/// @throws WrongContender if a timed loop gives a wrong result
std::optional<SteppingResult> measure_stepping(const MeasureRequest& request,
                                               MeasureProgress& progress);

/// `level`, `depth` or `texel`
const char* name_of(Drawn drawn);

/// Errors are magnitudes, before values are truncated for drawing.
///
///     made      {command, seed, compiler, date}
///     lengths   {least, most, spans}: pixels of the shortest and longest spans, spans per length
///     stepping  a list of {value, rule; unit of errors: level, depth or texel; ends: the range of
///               the values at the ends of spans; spans, pixels; max, bound: the largest error and
///               the largest bound; part_of_bound: the largest error as a part of its own bound,
///               0 ... 1, larger only if `beyond` names a pixel; last: {max, bound} of last pixels;
///               along: a list of {pixel, max, bound} of the longest spans; last_of: a list of
///               {pixels, max, bound}, of the last pixel of spans of that length; wrong: the share
///               of pixels that differ from the exact picture; most_off: by how much at most;
///               bands: {exact, drawn, wrong, widest}; missed: the share of the different values of
///               exact spans that are never drawn; ns: nanoseconds per pixel on this processor,
///               including its share of the setup of a span of 160 pixels, or null}
///     setups    a list of {cpu; divide, multiply: {min, max} clocks per value of a span}
///     pixels    a list of {loop, cpu; values: how many it steps; pixel: {min, max} clocks;
///               of_span: a list of {pixels, min, max}, per pixel of a span of that length
///               including its share of the setup}
///     times     {rounds, processor, flags; loops: a list of {what, of: pixel or value; ns: {min,
///               median, spread}}}
///     claims    as of --clocks
void to_json(support::Json& json, const SteppingResult& result);

}  // namespace fixproof::measure
