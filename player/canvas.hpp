/// @file
/// A screen of either kind of pixel.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "xsharp/picture.hpp"
#include "xsharp/raster/screen.hpp"
#include "xsharp/scene.hpp"
#include "xsharp/window/window.hpp"

namespace fixproof::player {

class Canvas : private boost::noncopyable {
 public:
  virtual ~Canvas() = default;

  virtual void show(const xsharp::Picture& picture) = 0;
  /// The picture that is shown, as the bytes of a PNG.
  [[nodiscard]] virtual std::string png() const = 0;
  /// The picture that is shown as indices of the palette, row by row; empty in true colour.
  [[nodiscard]] virtual std::span<const std::uint8_t> indices() const = 0;
  /// The picture that is shown, in a window.
  virtual void show_in(xsharp::Window& window) const = 0;
  [[nodiscard]] virtual xsharp::DrawingCount count() const = 0;
};

/// Of the scene's size, in 24 bits a pixel or with the scene's palette; surfaces are filled in the
/// scene's arithmetic.
/// @throws UsageError for an arithmetic that all_arithmetics() does not have
std::unique_ptr<Canvas> make_canvas(const xsharp::Scene& scene, bool true_color);

/// A canvas in the scene's palette if surfaces are filled by its arithmetic; otherwise nothing, for
/// then filling calls no routine.
std::unique_ptr<Canvas> canvas_of_surfaces(const xsharp::Scene& scene);

}  // namespace fixproof::player
