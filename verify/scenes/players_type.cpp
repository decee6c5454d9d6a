// The pipeline on the type, under each of its presets.
#include "verify/scenes/players.hpp"
#include "xsharp/animation.hpp"

namespace fixproof {

namespace {

using xsharp::Animation;
using xsharp::ArithmeticChoice;
using xsharp::Player;
using xsharp::Scene;

template <class Both, class Mul, class Div, class None>
std::unique_ptr<Player> of_target(const Scene& scene, const ArithmeticChoice& choice) {
  if (choice.mul_round && choice.div_round) return std::make_unique<Animation<Both>>(scene);
  if (choice.mul_round) return std::make_unique<Animation<Mul>>(scene);
  if (choice.div_round) return std::make_unique<Animation<Div>>(scene);
  return std::make_unique<Animation<None>>(scene);
}

}  // namespace

std::unique_ptr<Player> make_type_player(const Scene& scene, const ArithmeticChoice& choice) {
  using namespace fixed;
  if (choice.target == "i386") {
    return of_target<q16_16_i386, q16_16_i386_mul_rounded, q16_16_i386_div_rounded,
                     q16_16_i386_unrounded>(scene, choice);
  }
  if (choice.target == "i8088") {
    return of_target<q16_16_i8088, q16_16_i8088_mul_rounded, q16_16_i8088_div_rounded,
                     q16_16_i8088_unrounded>(scene, choice);
  }
  if (choice.target == "standard") return std::make_unique<Animation<q16_16>>(scene);
  if (choice.target == "saturating") return std::make_unique<Animation<q16_16_saturating>>(scene);
  if (choice.target == "trapping") return std::make_unique<Animation<q16_16_trapping>>(scene);
  return nullptr;
}

}  // namespace fixproof
