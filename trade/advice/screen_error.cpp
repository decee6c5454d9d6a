#include "trade/advice/screen_error.hpp"

#include <algorithm>
#include <array>
#include <boost/noncopyable.hpp>
#include <cmath>
#include <limits>
#include <memory>

#include "parties/with_number.hpp"
#include "trade/advice/screen_corners.hpp"

namespace fixproof::trade {

namespace {

using xsharp::RotationStyle;
using xsharp::Scene;

/// The exact corners of one object; a clipped corner is empty, an object out of range has none.
using ExactPlaces = std::vector<std::optional<ScreenPlace>>;

/// The largest squared distances, under the rounding divide and under the truncating one.
using OfBothDivides = std::array<double, 2>;

/// A multiply and a way of turning. Divides only follow the motion, so one motion serves both
/// divides.
class ScreenRun : private boost::noncopyable {
 public:
  ScreenRun() = default;
  virtual ~ScreenRun() = default;
  virtual void advance(std::size_t object) = 0;
  virtual OfBothDivides worst(std::size_t object, const ExactPlaces& exact) = 0;
};

void add_error(double& worst, const std::optional<ScreenPlace>& is, const ScreenPlace& should_be) {
  // A divide error leaves the corner without a position.
  const double x = is ? (*is)[0] - should_be[0] : std::numeric_limits<double>::infinity();
  const double y = is ? (*is)[1] - should_be[1] : 0;
  worst = std::max(worst, x * x + y * y);
}

/// @tparam N, Truncating the type with this multiply and either divide
template <class N, class Truncating>
class ScreenRunOf final : public ScreenRun {
 public:
  ScreenRunOf(const Scene& scene, const RotationStyle& style)
      : view_(xsharp::view_of<N>(scene, xsharp::concatenation_of(scene.arithmetic))),
        truncating_(xsharp::projection_of<Truncating>(scene)) {
    for (const auto& object : scene.objects) objects_.emplace_back(object, style);
  }

  void advance(std::size_t object) override { objects_[object].advance(); }

  OfBothDivides worst(std::size_t object, const ExactPlaces& exact) override {
    OfBothDivides worst{};
    if (exact.empty()) return worst;
    const auto& corners = objects_[object].view(view_);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (!exact[i] || !xsharp::inside(corners[i], view_.projection.slope)) continue;
      add_error(worst[0], screen_place(corners[i], view_.projection), *exact[i]);
      const auto same = [](N x) { return Truncating::from_raw(x.raw()); };
      const xsharp::Vec3<Truncating> corner{same(corners[i].x), same(corners[i].y),
                                            same(corners[i].z)};
      add_error(worst[1], screen_place(corner, truncating_), *exact[i]);
    }
    return worst;
  }

 private:
  xsharp::View<N> view_;
  xsharp::Projection<Truncating> truncating_;
  std::vector<ScreenCorners<N>> objects_;
};

std::unique_ptr<ScreenRun> screen_run(const Scene& scene, const Choice& choice) {
  const RotationStyle style{scene.trigonometry, scene.conversion, choice.turning.from_scratch,
                            choice.turning.restore_every, scene.restore_rows};
  return parties::with_build(choice.build, [&]<cases::Build build>() -> std::unique_ptr<ScreenRun> {
    using N = parties::NumberOf<cases::Build{build.target, build.mul_round, true}>;
    using Truncating = parties::NumberOf<cases::Build{build.target, build.mul_round, false}>;
    return std::make_unique<ScreenRunOf<N, Truncating>>(scene, style);
  });
}

class ExactRun {
 public:
  explicit ExactRun(const Scene& scene) : view_(xsharp::view_of<double>(scene)) {
    const RotationStyle style{scene.trigonometry, scene.conversion, true, 0};
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

struct Part {
  std::size_t run = 0;
  std::size_t divide = 0;
};

/// Choices that differ only in their divide share a run.
struct SharedRuns {
  std::vector<std::unique_ptr<ScreenRun>> runs;
  std::vector<Part> parts;  ///< one for each choice
};

SharedRuns shared_runs(const Scene& scene, std::span<const Choice> choices) {
  SharedRuns shared;
  std::vector<Choice> motions;
  for (const Choice& choice : choices) {
    Choice motion = choice;
    motion.build.div_round = true;
    const auto known = std::ranges::find(motions, motion);
    shared.parts.push_back(
        {static_cast<std::size_t>(known - motions.begin()), choice.build.div_round ? 0U : 1U});
    if (known != motions.end()) continue;
    motions.push_back(motion);
    shared.runs.push_back(screen_run(scene, motion));
  }
  return shared;
}

void note_error(ScreenError& error, double pixels, std::uint64_t frame, std::size_t object,
                double budget) {
  if (pixels > error.pixels) {
    error.pixels = pixels;
    error.frame = frame;
    error.object = object;
  }
  if (!error.over && pixels > budget) error.over = frame;
}

}  // namespace

std::vector<ScreenError> screen_errors(const Scene& scene, std::span<const Choice> choices,
                                       double budget, std::uint64_t& frames,
                                       const std::atomic<bool>& stop,
                                       const std::function<void(std::uint64_t)>& frame_done) {
  const SharedRuns shared = shared_runs(scene, choices);
  const auto& runs = shared.runs;
  const auto& parts = shared.parts;
  ExactRun exact(scene);
  std::vector<ScreenError> errors(choices.size());
  std::vector<OfBothDivides> worst(runs.size());
  const auto compare = [&](std::uint64_t frame, std::size_t object) {
    const ExactPlaces& places = exact.places(object);
    for (std::size_t i = 0; i < worst.size(); ++i) worst[i] = runs[i]->worst(object, places);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      note_error(errors[i], std::sqrt(worst[parts[i].run][parts[i].divide]), frame, object, budget);
    }
  };
  for (std::uint64_t frame = 0; frame < frames; ++frame) {
    if (stop) {
      frames = frame;
      break;
    }
    for (std::size_t object = 0; object < scene.objects.size(); ++object) {
      if (frame > 0) {
        for (const auto& run : runs) run->advance(object);
      }
      // The error of an object at rest does not change.
      if (frame == 0 || exact.advance(object)) compare(frame, object);
    }
    frame_done(frame + 1);
  }
  return errors;
}

}  // namespace fixproof::trade
