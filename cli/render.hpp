/// @file
/// Drawing a scene into files, as `fixproof render` and the report do it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "player/outputs.hpp"
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
  std::uint64_t frames = 0;  ///< fewer than wanted after an interrupt
  xsharp::Tally tally;
  xsharp::DrawingCount count;
  double seconds = 0;       ///< of drawing, without writing files
  std::string clocks;       ///< a line on the clocks of the listings; empty unless the model draws
  std::string differences;  ///< from the exact picture, if outputs.beside is given
  std::string older_frame;  ///< a file of an earlier, longer run; empty if there is none
};

/// Shows its progress on the terminal, and stops early when support::Interrupt::flag() is set. The
/// files are complete for the frames drawn.
/// @throws UsageError for outputs that clash or cannot be written, std::runtime_error naming the
///         frame in which the arithmetic failed
DrawnFrames draw_frames(const xsharp::Scene& scene, std::uint64_t frames,
                        const DrawOptions& options);

}  // namespace fixproof::cli
