// The pipeline on the register-level model, under each build of the listings.
#include "verify/scenes/model_number.hpp"
#include "verify/scenes/players.hpp"
#include "xsharp/animation.hpp"

namespace fixproof {

namespace {

using xsharp::Animation;
using xsharp::ArithmeticChoice;
using xsharp::Player;
using xsharp::Scene;

template <Target target>
std::unique_ptr<Player> of_target(const Scene& scene, const ArithmeticChoice& choice) {
  const auto make = [&scene]<bool mul, bool div>() -> std::unique_ptr<Player> {
    return std::make_unique<Animation<ModelNumber<target, mul, div>>>(scene);
  };
  if (choice.mul_round && choice.div_round) return make.template operator()<true, true>();
  if (choice.mul_round) return make.template operator()<true, false>();
  if (choice.div_round) return make.template operator()<false, true>();
  return make.template operator()<false, false>();
}

}  // namespace

std::unique_ptr<Player> make_model_player(const Scene& scene, const ArithmeticChoice& choice) {
  if (choice.target == "i386") return of_target<Target::i386>(scene, choice);
  if (choice.target == "i8088") return of_target<Target::i8088>(scene, choice);
  return nullptr;
}

}  // namespace fixproof
