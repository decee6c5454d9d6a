#include "measure/trade/advice/screen_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fixproof::trade {

namespace {

class ExactRun {
 public:
  explicit ExactRun(const xsharp::Scene& scene) : view_(xsharp::view_of<double>(scene)) {
    const xsharp::RotationStyle style{scene.trigonometry, scene.conversion, true, 0};
    for (const auto& object : scene.objects) objects_.emplace_back(object, style);
  }

  bool advance(std::size_t object) { return objects_[object].advance(); }

  const ExactPlaces& places(std::size_t object) {
    places_.clear();
    for (const auto& corner : objects_[object].view(view_)) {
      const bool kept = xsharp::inside(corner, view_.projection.slope);
      places_.push_back(kept ? screen_place(corner, view_.projection) : std::nullopt);
    }
    return places_;
  }

 private:
  xsharp::View<double> view_;
  std::vector<ScreenCorners<double>> objects_;
  ExactPlaces places_;
};

}  // namespace

void add_error(double& worst, const std::optional<ScreenPlace>& is, const ScreenPlace& should_be) {
  // A divide error leaves the corner without a position.
  const double x = is ? (*is)[0] - should_be[0] : std::numeric_limits<double>::infinity();
  const double y = is ? (*is)[1] - should_be[1] : 0;
  worst = std::max(worst, x * x + y * y);
}

void note_error(ScreenError& error, double squared, std::uint64_t frame, std::size_t object,
                double budget) {
  const double pixels = std::sqrt(squared);
  if (pixels > error.pixels) {
    error.pixels = pixels;
    error.frame = frame;
    error.object = object;
  }
  if (!error.over && pixels > budget) error.over = frame;
}

void compare_with_exact(const xsharp::Scene& scene,
                        const std::vector<std::unique_ptr<ScreenRun>>& runs, std::uint64_t& frames,
                        const std::atomic<bool>& stop,
                        const std::function<void(std::uint64_t, std::size_t)>& compared,
                        const std::function<void(std::uint64_t)>& frame_done) {
  ExactRun exact(scene);
  for (std::uint64_t frame = 0; frame < frames; ++frame) {
    if (stop) {
      frames = frame;
      break;
    }
    for (std::size_t object = 0; object < scene.objects.size(); ++object) {
      if (frame > 0) {
        for (const auto& run : runs) {
          if (run) run->advance(object);
        }
      }
      // The error of an object at rest does not change.
      if (frame != 0 && !exact.advance(object)) continue;
      const ExactPlaces& places = exact.places(object);
      for (const auto& run : runs) {
        if (run) run->compare(object, places);
      }
      compared(frame, object);
    }
    frame_done(frame + 1);
  }
}

}  // namespace fixproof::trade
