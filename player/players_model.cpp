// The pipeline on the register-level model, under each build of the listings.
#include "player/model_number.hpp"
#include "player/players.hpp"
#include "player/surfaces.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/raster/step_filler.hpp"

namespace fixproof::player {

namespace {

using xsharp::ArithmeticChoice;
using xsharp::Scene;

template <cases::Target target, class Make>
auto of_model_target(const ArithmeticChoice& choice, const Make& make) {
  if (choice.mul_round && choice.div_round) {
    return make.template operator()<ModelNumber<target, true, true>>();
  }
  if (choice.mul_round) return make.template operator()<ModelNumber<target, true, false>>();
  if (choice.div_round) return make.template operator()<ModelNumber<target, false, true>>();
  return make.template operator()<ModelNumber<target, false, false>>();
}

}  // namespace

std::unique_ptr<xsharp::Player> make_model_player(const Scene& scene,
                                                  const ArithmeticChoice& choice) {
  const auto make = [&]<class N>() -> std::unique_ptr<xsharp::Player> {
    return std::make_unique<xsharp::Animation<N>>(scene, 1, xsharp::concatenation_of(choice));
  };
  if (choice.target == "i386") return of_model_target<cases::Target::i386>(choice, make);
  if (choice.target == "i8088") return of_model_target<cases::Target::i8088>(choice, make);
  return nullptr;
}

std::unique_ptr<xsharp::SurfaceFiller> make_model_surfaces(
    const Scene& scene, const ArithmeticChoice& choice,
    std::unique_ptr<const xsharp::SpanLoops> loops) {
  const auto make = [&]<class N>() -> std::unique_ptr<xsharp::SurfaceFiller> {
    return std::make_unique<xsharp::StepFiller<N>>(scene, std::move(loops));
  };
  if (choice.target == "i386") return of_model_target<cases::Target::i386>(choice, make);
  if (choice.target == "i8088") return of_model_target<cases::Target::i8088>(choice, make);
  return nullptr;
}

}  // namespace fixproof::player
