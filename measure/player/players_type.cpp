// The players and surface fillers of the type, one for each preset.
#include "measure/player/players.hpp"
#include "measure/player/surfaces.hpp"
#include "verify/parties/with_number.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/raster/step_filler.hpp"

namespace fixproof::player {

namespace {

using xsharp::ArithmeticChoice;
using xsharp::Scene;

/// Calls make(std::type_identity<N>()) for the type's number N; null for any other target.
template <class Make>
auto with_type(const ArithmeticChoice& choice, const Make& make)
    -> decltype(make(std::type_identity<double>())) {
  if (const auto build = build_of(choice)) return parties::with_number(*build, make);
  if (choice.target == "saturating") return make(std::type_identity<fixproof::q16_16_saturating>());
  if (choice.target == "trapping") return make(std::type_identity<fixproof::q16_16_trapping>());
  return nullptr;
}

}  // namespace

std::unique_ptr<xsharp::Player> make_type_player(const Scene& scene, const ArithmeticChoice& choice,
                                                 std::size_t threads) {
  return with_type(choice,
                   [&]<class N>(std::type_identity<N> /*type*/) -> std::unique_ptr<xsharp::Player> {
                     return std::make_unique<xsharp::Animation<N>>(
                         scene, threads, xsharp::concatenation_of(choice));
                   });
}

std::unique_ptr<xsharp::SurfaceFiller> make_type_surfaces(
    const Scene& scene, const ArithmeticChoice& choice,
    std::unique_ptr<const xsharp::SpanLoops> loops) {
  return with_type(
      choice,
      [&]<class N>(std::type_identity<N> /*type*/) -> std::unique_ptr<xsharp::SurfaceFiller> {
        return std::make_unique<xsharp::StepFiller<N>>(scene, std::move(loops));
      });
}

}  // namespace fixproof::player
