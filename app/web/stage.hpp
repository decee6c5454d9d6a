/// @file
/// A scene that plays in two arithmetics: one that can be switched while the scene runs, and one to
/// compare with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/web/switched_number.hpp"
#include "xsharp/player.hpp"
#include "xsharp/raster/screen.hpp"
#include "xsharp/raster/surface_filler.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::web {

/// Returns the scenes and the arithmetics, with the exact one (double) last.
/// @return JSON
std::string stages();

class Stage {
 public:
  enum Side : std::uint8_t { played, compared };

  /// Plays the scene from its first frame in both arithmetics.
  /// @param scene       an index of scene_names
  /// @param arithmetics an index of the arithmetics of stages() for each side
  Stage(std::size_t scene, std::array<std::size_t, 2> arithmetics);

  /// Switches the played arithmetic at the current frame, and keeps the positions that the old one
  /// computed. A switch to or from the exact arithmetic, which has other numbers, restarts the
  /// played side from its first frame.
  void switch_arithmetic(std::size_t arithmetic);

  /// Moves both sides towards a frame, by at most `moves` frames each. For an earlier frame, a side
  /// restarts from its first frame.
  /// @return the frame that both sides have reached
  std::uint32_t seek(std::uint32_t frame, std::uint32_t moves);

  /// Draws the current frame of both sides.
  /// @return the number of pixels that differ
  std::uint32_t draw();

  /// The last drawing as red, green, blue and opacity, row by row. pixels() is a side;
  /// differences() is the differing pixels, white on black.
  [[nodiscard]] std::span<const std::uint8_t> pixels(Side side) const {
    return sides_.at(side).pixels;
  }
  [[nodiscard]] std::span<const std::uint8_t> differences() const { return differences_; }
  /// The last drawing of a side as palette indices.
  [[nodiscard]] std::span<const std::uint8_t> indices(Side side) const {
    return sides_.at(side).screen->page().pixels();
  }

 private:
  struct Playing {
    std::size_t arithmetic = 0;
    std::uint32_t frame = 0;
    std::unique_ptr<xsharp::Player> player{};
    std::unique_ptr<xsharp::SurfaceFiller> surfaces{};
    std::unique_ptr<xsharp::Screen<std::uint8_t>> screen{};
    std::vector<std::uint8_t> pixels{};
  };

  void start(Playing& side);

  xsharp::Scene scene_;
  std::array<Playing, 2> sides_{};
  std::vector<std::uint8_t> differences_{};
};

}  // namespace fixproof::web
