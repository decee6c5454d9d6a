/// @file
/// What a stepped pixel takes on each processor, its share of what its span begins with included.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "measure/clocks/claims.hpp"
#include "measure/clocks/span_clocks.hpp"

namespace fixproof::measure {

/// What a span begins with for each value that is stepped, rounded: a FixedDiv for the slope and a
/// FixedMul for the start, means of calls over random spans, without the caller's part.
struct SetupClocks {
  x86model::Cpu cpu{};  ///< 8088 and 286 run the listings for the 8088, 386 and 486 their own
  Bounds divide;        ///< on an 8088 the larger of table and bus time, as all clocks here
  Bounds multiply;
};
std::vector<SetupClocks> measure_setup_clocks(std::uint64_t seed);

/// Lengths of spans that a pixel's clocks are given for.
inline constexpr std::array<std::uint32_t, 3> costed_lengths{10, 40, 160};

/// A loop, counted by DEC and JNZ, on one processor.
struct PixelCost {
  std::string loop;
  x86model::Cpu cpu{};
  int values = 1;                                     ///< that it steps
  Bounds pixel;                                       ///< clocks of the loop
  std::array<Bounds, costed_lengths.size()> of_span;  ///< with the pixel's share of the beginning
};
std::vector<PixelCost> measure_pixel_costs(const std::vector<SetupClocks>& setups);

/// What the document says of its methods, beside the claims of loop_claims(). Texts are ours.
std::vector<Claim> judge_stepping_claims(const std::vector<SetupClocks>& setups);

}  // namespace fixproof::measure
