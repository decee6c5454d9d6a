/// @file
/// The clocks of every routine and inner loop, and the published claims about them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "measure/clocks/call_clocks.hpp"
#include "measure/clocks/claims.hpp"
#include "measure/clocks/span_clocks.hpp"
#include "measure/measure.hpp"
#include "support/json.hpp"

namespace fixproof::measure {

/// The listings' mean share of a frame on an 8088.
struct FrameOn8088 {
  std::string scene;
  bool rounds = true;
  double code_bytes = 0;
  double data_bytes = 0;
  Clocks clocks;
};

struct ClockResult {
  std::uint64_t seed = 0;
  std::vector<std::string> scenes;  ///< the scenes whose operands were recorded
  std::vector<CallClocks> rows;
  std::vector<Claim> claims;  ///< empty without a scene
  std::vector<FrameOn8088> frames;
  std::vector<LoopClocks> loops;
  std::vector<LoopClaim> loop_claims;
};

std::optional<ClockResult> measure_clocks(const MeasureRequest& request, MeasureProgress& progress);

void to_json(support::Json& json, const ClockResult& result);

}  // namespace fixproof::measure
