/// @file
/// Clocks per stepped pixel on each processor, including a share of the span's setup.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "measure/clocks/claims.hpp"
#include "measure/clocks/span_clocks.hpp"

namespace fixproof::measure {

/// The setup per stepped value with rounding: a FixedDiv for the slope and a FixedMul for the
/// start. Means of calls over random spans, without the caller's code.
struct SetupClocks {
  x86model::Cpu cpu{};  ///< 8088 and 286 run the 8088 listings, 386 and 486 the 386 ones
  Bounds divide;        ///< on an 8088, all clocks here are the larger of table and bus time
  Bounds multiply;
};
std::vector<SetupClocks> measure_setup_clocks(std::uint64_t seed);

/// Lengths of the spans whose clocks per pixel are reported.
inline constexpr std::array<std::uint32_t, 3> costed_lengths{10, 40, 160};

/// The cost of a loop on one processor, counted by DEC and JNZ.
struct PixelCost {
  std::string loop;
  x86model::Cpu cpu{};
  int values = 1;                                     ///< number of stepped values
  Bounds pixel;                                       ///< clocks of the loop
  std::array<Bounds, costed_lengths.size()> of_span;  ///< including the pixel's share of the setup
};
std::vector<PixelCost> measure_pixel_costs(const std::vector<SetupClocks>& setups);

/// Judges the document's claims about its methods, except those of loop_claims(). The texts are
/// ours.
std::vector<Claim> judge_stepping_claims(const std::vector<SetupClocks>& setups);

}  // namespace fixproof::measure
