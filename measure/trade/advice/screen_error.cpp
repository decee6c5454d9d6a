#include "measure/trade/advice/screen_error.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "measure/trade/advice/screen_corners.hpp"
#include "measure/trade/advice/screen_run.hpp"
#include "verify/parties/with_number.hpp"

namespace fixproof::trade {

namespace {

using xsharp::RotationStyle;
using xsharp::Scene;

/// The largest squared distances, under the rounding divide and under the truncating one. Divides
/// only follow the motion, so one motion serves both.
using OfBothDivides = std::array<double, 2>;

/// @tparam N, Truncating the type with this multiply and either divide
template <class N, class Truncating>
class ScreenRunOf final : public ScreenRun {
 public:
  /// @param worst of the object that was compared last
  ScreenRunOf(const Scene& scene, const RotationStyle& style, OfBothDivides& worst)
      : view_(xsharp::view_of<N>(scene, xsharp::concatenation_of(scene.arithmetic))),
        truncating_(xsharp::projection_of<Truncating>(scene)),
        worst_(worst) {
    for (const auto& object : scene.objects) objects_.emplace_back(object, style);
  }

  void advance(std::size_t object) override { objects_[object].advance(); }

  void compare(std::size_t object, const ExactPlaces& exact) override {
    worst_ = {};
    if (exact.empty()) return;
    const auto& corners = objects_[object].view(view_);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (!exact[i] || !xsharp::inside(corners[i], view_.projection.slope)) continue;
      add_error(worst_[0], screen_place(corners[i], view_.projection), *exact[i]);
      const auto same = [](N x) { return Truncating::from_raw(x.raw()); };
      const xsharp::Vec3<Truncating> corner{same(corners[i].x), same(corners[i].y),
                                            same(corners[i].z)};
      add_error(worst_[1], screen_place(corner, truncating_), *exact[i]);
    }
  }

 private:
  xsharp::View<N> view_;
  xsharp::Projection<Truncating> truncating_;
  std::vector<ScreenCorners<N>> objects_;
  OfBothDivides& worst_;
};

std::unique_ptr<ScreenRun> screen_run(const Scene& scene, const Choice& choice,
                                      OfBothDivides& worst) {
  const RotationStyle style{scene.trigonometry, scene.conversion, choice.turning.from_scratch,
                            choice.turning.restore_every, scene.restore_rows};
  return parties::with_build(choice.build, [&]<cases::Build build>() -> std::unique_ptr<ScreenRun> {
    using N = parties::NumberOf<cases::Build{build.target, build.mul_round, true}>;
    using Truncating = parties::NumberOf<cases::Build{build.target, build.mul_round, false}>;
    return std::make_unique<ScreenRunOf<N, Truncating>>(scene, style, worst);
  });
}

/// A run and its divide.
struct Part {
  std::size_t run = 0;
  std::size_t divide = 0;
};

}  // namespace

std::vector<ScreenError> screen_errors(const Scene& scene, std::span<const Choice> choices,
                                       double budget, std::uint64_t& frames,
                                       const std::atomic<bool>& stop,
                                       const std::function<void(std::uint64_t)>& frame_done) {
  // Choices that differ only in their divide share a run.
  std::vector<Choice> motions;
  std::vector<Part> parts;
  for (const Choice& choice : choices) {
    Choice motion = choice;
    motion.build.div_round = true;
    const auto known = std::ranges::find(motions, motion);
    parts.push_back(
        {static_cast<std::size_t>(known - motions.begin()), choice.build.div_round ? 0U : 1U});
    if (known == motions.end()) motions.push_back(motion);
  }
  std::vector<OfBothDivides> worst(motions.size());
  std::vector<std::unique_ptr<ScreenRun>> runs;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    runs.push_back(screen_run(scene, motions[i], worst[i]));
  }
  std::vector<ScreenError> errors(choices.size());
  const auto compared = [&](std::uint64_t frame, std::size_t object) {
    for (std::size_t i = 0; i < errors.size(); ++i) {
      note_error(errors[i], worst[parts[i].run][parts[i].divide], frame, object, budget);
    }
  };
  compare_with_exact(scene, runs, frames, stop, compared, frame_done);
  return errors;
}

}  // namespace fixproof::trade
