#include "measure/player/surfaces.hpp"

#include <fmt/format.h>

#include "measure/player/model_loops.hpp"
#include "measure/player/players.hpp"
#include "support/usage_error.hpp"
#include "xsharp/raster/exact_filler.hpp"

namespace fixproof::player {

std::unique_ptr<xsharp::SurfaceFiller> make_surfaces(const xsharp::Scene& scene,
                                                     const xsharp::ArithmeticChoice& choice) {
  if (!xsharp::interpolates(scene)) return nullptr;
  if (choice.by == "double") return std::make_unique<xsharp::ExactFiller>(scene);
  std::unique_ptr<xsharp::SurfaceFiller> surfaces;
  if (choice.by == "model") {
    surfaces = make_model_surfaces(scene, choice, std::make_unique<ModelLoops>());
  } else if (choice.by == "type") {
    surfaces = make_type_surfaces(scene, choice, std::make_unique<xsharp::PlainLoops>());
  }
  if (!surfaces) throw no_arithmetic(choice);
  return surfaces;
}

}  // namespace fixproof::player
