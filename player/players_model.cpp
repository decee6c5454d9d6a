// The players and surface fillers of the register-level model, one for each build of the listings.
#include "parties/with_number.hpp"
#include "player/model_number.hpp"
#include "player/players.hpp"
#include "player/surfaces.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/raster/step_filler.hpp"

namespace fixproof::player {

namespace {

using xsharp::ArithmeticChoice;
using xsharp::Scene;

/// Calls make.operator()<N>() for the model's number N; null unless the choice is a build.
template <class Result, class Make>
std::unique_ptr<Result> with_model(const ArithmeticChoice& choice, const Make& make) {
  const auto build = build_of(choice);
  if (!build) return nullptr;
  return parties::with_build(*build, [&]<cases::Build constant>() -> std::unique_ptr<Result> {
    if constexpr (constant.target == cases::Target::standard) {
      return nullptr;
    } else {
      return make.template operator()<ModelNumber<constant>>();
    }
  });
}

}  // namespace

std::unique_ptr<xsharp::Player> make_model_player(const Scene& scene,
                                                  const ArithmeticChoice& choice) {
  return with_model<xsharp::Player>(choice, [&]<class N>() {
    return std::make_unique<xsharp::Animation<N>>(scene, 1, xsharp::concatenation_of(choice));
  });
}

std::unique_ptr<xsharp::SurfaceFiller> make_model_surfaces(
    const Scene& scene, const ArithmeticChoice& choice,
    std::unique_ptr<const xsharp::SpanLoops> loops) {
  return with_model<xsharp::SurfaceFiller>(choice, [&]<class N>() {
    return std::make_unique<xsharp::StepFiller<N>>(scene, std::move(loops));
  });
}

}  // namespace fixproof::player
