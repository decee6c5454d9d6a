#include "verify/scenes/surfaces.hpp"

#include <fmt/format.h>

#include "verify/scenes/players.hpp"
#include "verify/usage_error.hpp"
#include "xsharp/raster/exact_filler.hpp"

namespace fixproof {

std::unique_ptr<xsharp::SurfaceFiller> make_surfaces(const xsharp::Scene& scene,
                                                     const xsharp::ArithmeticChoice& choice) {
  if (!xsharp::interpolates(scene)) return nullptr;
  if (choice.by == "double") return std::make_unique<xsharp::ExactFiller>(scene);
  auto loops = std::make_unique<xsharp::PlainLoops>();
  auto surfaces = choice.by == "model"  ? make_model_surfaces(scene, choice, std::move(loops))
                  : choice.by == "type" ? make_type_surfaces(scene, choice, std::move(loops))
                                        : nullptr;
  if (!surfaces) throw UsageError(fmt::format("no arithmetic {}", name_of(choice)));
  return surfaces;
}

}  // namespace fixproof
