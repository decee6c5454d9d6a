// The pipeline on the type, under each of its presets.
#include "player/players.hpp"
#include "player/surfaces.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/raster/step_filler.hpp"

namespace fixproof::player {

namespace {

using xsharp::ArithmeticChoice;
using xsharp::Scene;

template <class Both, class Mul, class Div, class None, class Make>
auto of_type_target(const ArithmeticChoice& choice, const Make& make) {
  if (choice.mul_round && choice.div_round) return make.template operator()<Both>();
  if (choice.mul_round) return make.template operator()<Mul>();
  if (choice.div_round) return make.template operator()<Div>();
  return make.template operator()<None>();
}

/// @param make makes something of a number type; @return null for a target that the type has not
template <class Make>
auto of_type(const ArithmeticChoice& choice, const Make& make)
    -> decltype(make.template operator()<double>()) {
  using namespace fixed;
  if (choice.target == "i386") {
    return of_type_target<q16_16_i386, q16_16_i386_mul_rounded, q16_16_i386_div_rounded,
                          q16_16_i386_unrounded>(choice, make);
  }
  if (choice.target == "i8088") {
    return of_type_target<q16_16_i8088, q16_16_i8088_mul_rounded, q16_16_i8088_div_rounded,
                          q16_16_i8088_unrounded>(choice, make);
  }
  if (choice.target == "standard") return make.template operator()<q16_16>();
  if (choice.target == "saturating") return make.template operator()<q16_16_saturating>();
  if (choice.target == "trapping") return make.template operator()<q16_16_trapping>();
  return nullptr;
}

}  // namespace

std::unique_ptr<xsharp::Player> make_type_player(const Scene& scene, const ArithmeticChoice& choice,
                                                 std::size_t threads) {
  return of_type(choice, [&]<class N>() -> std::unique_ptr<xsharp::Player> {
    return std::make_unique<xsharp::Animation<N>>(scene, threads, xsharp::concatenation_of(choice));
  });
}

std::unique_ptr<xsharp::SurfaceFiller> make_type_surfaces(
    const Scene& scene, const ArithmeticChoice& choice,
    std::unique_ptr<const xsharp::SpanLoops> loops) {
  return of_type(choice, [&]<class N>() -> std::unique_ptr<xsharp::SurfaceFiller> {
    return std::make_unique<xsharp::StepFiller<N>>(scene, std::move(loops));
  });
}

}  // namespace fixproof::player
