/// @file
/// What fills the surfaces of a scene, under the arithmetic that is chosen.
#pragma once

#include <memory>

#include "xsharp/raster/span_loops.hpp"
#include "xsharp/raster/surface_filler.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::player {

/// By stepping under the type and the model, the model's inner loops runs of the listings; in
/// double exactly, at every pixel. Null where nothing of the scene is interpolated.
/// @throws UsageError for a choice that all_arithmetics() does not have
std::unique_ptr<xsharp::SurfaceFiller> make_surfaces(const xsharp::Scene& scene,
                                                     const xsharp::ArithmeticChoice& choice);

/// Under one party's arithmetic, with inner loops of any party. Null if there is none.
std::unique_ptr<xsharp::SurfaceFiller> make_type_surfaces(
    const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice,
    std::unique_ptr<const xsharp::SpanLoops> loops);
std::unique_ptr<xsharp::SurfaceFiller> make_model_surfaces(
    const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice,
    std::unique_ptr<const xsharp::SpanLoops> loops);

}  // namespace fixproof::player
