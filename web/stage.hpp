/// @file
/// A scene that plays twice: in one arithmetic, which can be switched while it runs, and in another
/// to compare with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "web/switched_number.hpp"
#include "xsharp/player.hpp"
#include "xsharp/raster/screen.hpp"
#include "xsharp/raster/surface_filler.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::web {

/// The scenes and the arithmetics, the exact one (double) last.
/// @return JSON
std::string stages();

class Stage {
 public:
  enum Side : std::uint8_t { played, compared };

  /// Plays the scene from its first frame in both arithmetics.
  /// @param scene of scene_names; @param arithmetics of stages(), of each side
  Stage(std::size_t scene, std::array<std::size_t, 2> arithmetics);

  /// Switches the side's arithmetic at the current frame: what it has moved stays moved. To or from
  /// the exact arithmetic, which has other numbers, the side starts from its first frame.
  void switch_arithmetic(Side side, std::size_t arithmetic);

  /// Moves both sides towards a frame by at most `moves` frames each. An earlier frame than the
  /// current one starts from the first.
  /// @return the frame that both have reached
  std::uint32_t seek(std::uint32_t frame, std::uint32_t moves);

  /// Draws the current frame of both sides.
  /// @return how many pixels differ
  std::uint32_t draw();

  /// The last drawing as red, green, blue and opacity, row by row: of a side, or the differences,
  /// white on black.
  [[nodiscard]] std::span<const std::uint8_t> pixels(Side side) const {
    return sides_.at(side).pixels;
  }
  [[nodiscard]] std::span<const std::uint8_t> differences() const { return differences_; }
  /// The last drawing as palette indices.
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
