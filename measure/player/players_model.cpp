// The players and surface fillers of the register-level model, for each build of the listings.
#include "measure/player/model_number.hpp"
#include "measure/player/players.hpp"
#include "measure/player/surfaces.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/raster/step_filler.hpp"

namespace fixproof::player {

namespace {

using xsharp::ArithmeticChoice;
using xsharp::Scene;

/// A build of the listings; empty for any other choice. It is never repaired: only ConcatXforms has
/// a repair, and the animation says for each call whether to use it.
std::optional<cases::Build> listing_of(const ArithmeticChoice& choice) {
  auto build = build_of(choice);
  if (build) build->repaired = false;
  return build && build->target != cases::Target::standard ? build : std::nullopt;
}

class ModelPlayer final : public xsharp::Player {
 public:
  ModelPlayer(const Scene& scene, const cases::Build& build, xsharp::Concatenation concatenation)
      : build_(build) {
    const InBuild in(build_);
    animation_ = std::make_unique<xsharp::Animation<ModelNumber>>(scene, 1, concatenation);
  }

  xsharp::Tally draw(xsharp::Picture& picture) override {
    const InBuild in(build_);
    return animation_->draw(picture);
  }
  void move() override {
    const InBuild in(build_);
    animation_->move();
  }
  [[nodiscard]] std::span<const std::size_t> order() const override { return animation_->order(); }
  [[nodiscard]] xsharp::ObjectState state(std::size_t object) const override {
    const InBuild in(build_);
    return animation_->state(object);
  }
  void switch_light(std::size_t light) override { animation_->switch_light(light); }

 private:
  cases::Build build_;
  std::unique_ptr<xsharp::Animation<ModelNumber>> animation_;
};

class ModelFiller final : public xsharp::StepFiller<ModelNumber> {
 public:
  ModelFiller(const Scene& scene, const cases::Build& build,
              std::unique_ptr<const xsharp::SpanLoops> loops)
      : StepFiller(scene, std::move(loops)), build_(build) {}

  void begin(const xsharp::Picture& picture, std::int32_t width, std::int32_t height) override {
    const InBuild in(build_);
    StepFiller::begin(picture, width, height);
  }

 private:
  std::span<const xsharp::PixelRow> find_rows(const xsharp::Picture& picture,
                                              const xsharp::Polygon& polygon,
                                              const xsharp::Surface& surface, std::int32_t width,
                                              std::int32_t height) override {
    const InBuild in(build_);
    return StepFiller::find_rows(picture, polygon, surface, width, height);
  }
  void draw(std::size_t row, const xsharp::Surface& surface, std::span<std::uint8_t> out,
            std::uint8_t pixel, std::span<std::uint8_t> set) override {
    const InBuild in(build_);
    StepFiller::draw(row, surface, out, pixel, set);
  }

  cases::Build build_;
};

}  // namespace

std::unique_ptr<xsharp::Player> make_model_player(const Scene& scene,
                                                  const ArithmeticChoice& choice) {
  const auto build = listing_of(choice);
  if (!build) return nullptr;
  return std::make_unique<ModelPlayer>(scene, *build, xsharp::concatenation_of(choice));
}

std::unique_ptr<xsharp::SurfaceFiller> make_model_surfaces(
    const Scene& scene, const ArithmeticChoice& choice,
    std::unique_ptr<const xsharp::SpanLoops> loops) {
  const auto build = listing_of(choice);
  if (!build) return nullptr;
  return std::make_unique<ModelFiller>(scene, *build, std::move(loops));
}

}  // namespace fixproof::player
