/// @file
/// A screen in the scene's palette or in true colour.
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
  /// The shown picture as the bytes of a PNG.
  [[nodiscard]] virtual std::string png() const = 0;
  /// The shown picture as palette indices, row-major; empty in true colour.
  [[nodiscard]] virtual std::span<const std::uint8_t> indices() const = 0;
  virtual void show_in(xsharp::Window& window) const = 0;
  [[nodiscard]] virtual xsharp::DrawingCount count() const = 0;
};

/// Makes a canvas of the scene's size, in 24 bits per pixel or with the scene's palette. It fills
/// surfaces in the scene's arithmetic.
/// @throws UsageError for an arithmetic that does not exist
std::unique_ptr<Canvas> make_canvas(const xsharp::Scene& scene, bool true_color);

/// Makes a canvas in the scene's palette if the scene's arithmetic fills the surfaces. Otherwise
/// null, because filling then calls no routine.
std::unique_ptr<Canvas> canvas_of_surfaces(const xsharp::Scene& scene);

}  // namespace fixproof::player
