/// @file
/// What a pixel of every inner loop takes by Intel's tables, and what its source says of that.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "support/json.hpp"
#include "x86model/clocks.hpp"
#include "x86model/loop.hpp"

namespace fixproof::trade {

/// What happens to the pixels of a span. Only the depth test has hidden ones.
enum class Pixels { drawn, hidden };

/// Clocks a pixel within a long span, bounds included: entering and leaving the loop is left out.
struct PixelClocks {
  double min = 0;
  double max = 0;
  double bus = 0;  ///< of an 8088: a pixel takes at least the larger of table and bus time
};

/// @return nothing where the processor cannot run the form
std::optional<PixelClocks> pixel_clocks(const x86model::LoopForm& form, Pixels pixels,
                                        x86model::Cpu cpu);

/// How many times as many clocks one way to draw takes as another, on one processor. An 8088 has
/// two gains: one by the table, one by the larger of table and bus time.
struct LoopGain {
  std::string where;  ///< which loops and processor
  double min = 0;
  double max = 0;
};
/// A statement of the source: that there is a gain.
struct LoopClaim {
  std::string text;
  std::string place;  ///< where it is printed
  std::vector<LoopGain> gains;
};
/// Two pixels a store, DEC and JNZ in place of LOOP, unrolling.
std::vector<LoopClaim> loop_claims();

/// Both as tables, and as JSON.
std::string span_clocks_text();
support::Json span_clocks_json();

}  // namespace fixproof::trade
