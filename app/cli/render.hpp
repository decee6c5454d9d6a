/// @file
/// Draws a scene into files for `fixproof render` and the report.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "measure/player/outputs.hpp"
#include "xsharp/player.hpp"
#include "xsharp/raster/screen.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::cli {

struct DrawOptions {
  player::OutputNames outputs;
  bool true_color = false;
  std::size_t threads = 1;
};

struct DrawnFrames {
  std::uint64_t frames = 0;  ///< fewer than requested after an interrupt
  xsharp::Tally tally;
  xsharp::DrawingCount count;
  double seconds = 0;       ///< drawing time, without writing files
  std::string clocks;       ///< one line, the listings' clocks; empty unless the model draws
  std::string differences;  ///< from the exact picture; empty without outputs.beside
  std::string older_frame;  ///< a leftover file of an earlier, longer run, or empty
};

/// Shows progress on the terminal and stops early when support::Interrupt::flag() is set. The files
/// are complete for the frames drawn.
/// @throws UsageError if outputs clash or cannot be written, std::runtime_error with the frame
///         number if the arithmetic fails
DrawnFrames draw_frames(const xsharp::Scene& scene, std::uint64_t frames,
                        const DrawOptions& options);

}  // namespace fixproof::cli
