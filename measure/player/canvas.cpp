#include "measure/player/canvas.hpp"

#include <concepts>
#include <cstdint>

#include "measure/player/surfaces.hpp"
#include "xsharp/files/png.hpp"

namespace fixproof::player {

namespace {

template <class Pixel>
class ScreenCanvas final : public Canvas {
 public:
  explicit ScreenCanvas(const xsharp::Scene& scene)
      : palette_(xsharp::palette_of(scene.palette)),
        surfaces_(make_surfaces(scene, scene.arithmetic)),
        screen_(scene.width, scene.height, scene.palette, scene.background, surfaces_.get()) {}

  void show(const xsharp::Picture& picture) override { screen_.show(picture); }
  [[nodiscard]] std::string png() const override {
    if constexpr (std::same_as<Pixel, std::uint8_t>) {
      return xsharp::encode_png(screen_.page(), palette_);
    } else {
      return xsharp::encode_png(screen_.page());
    }
  }
  [[nodiscard]] std::span<const std::uint8_t> indices() const override {
    if constexpr (std::same_as<Pixel, std::uint8_t>) {
      return screen_.page().pixels();
    } else {
      return {};
    }
  }
  void show_in(xsharp::Window& window) const override {
    if constexpr (std::same_as<Pixel, std::uint8_t>) {
      window.show(screen_.page(), palette_);
    } else {
      window.show(screen_.page());
    }
  }
  [[nodiscard]] xsharp::DrawingCount count() const override { return screen_.count(); }

 private:
  const xsharp::Palette& palette_;
  std::unique_ptr<xsharp::SurfaceFiller> surfaces_;
  xsharp::Screen<Pixel> screen_;
};

}  // namespace

std::unique_ptr<Canvas> make_canvas(const xsharp::Scene& scene, bool true_color) {
  if (true_color) return std::make_unique<ScreenCanvas<std::uint32_t>>(scene);
  return std::make_unique<ScreenCanvas<std::uint8_t>>(scene);
}

std::unique_ptr<Canvas> canvas_of_surfaces(const xsharp::Scene& scene) {
  return xsharp::interpolates(scene) ? make_canvas(scene, false) : nullptr;
}

}  // namespace fixproof::player
