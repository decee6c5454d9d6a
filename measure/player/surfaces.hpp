/// @file
/// The surface fillers of each arithmetic.
#pragma once

#include <memory>

#include "xsharp/raster/span_loops.hpp"
#include "xsharp/raster/surface_filler.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::player {

/// Makes the surface filler of an arithmetic. The type and the model step along spans; the model
/// runs the listings for that. Double is exact at every pixel. Null without interpolation.
/// @throws UsageError for an arithmetic that does not exist
std::unique_ptr<xsharp::SurfaceFiller> make_surfaces(const xsharp::Scene& scene,
                                                     const xsharp::ArithmeticChoice& choice);

/// Make a filler of one party's arithmetic with any inner loops; null if the party lacks it.
std::unique_ptr<xsharp::SurfaceFiller> make_type_surfaces(
    const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice,
    std::unique_ptr<const xsharp::SpanLoops> loops);
std::unique_ptr<xsharp::SurfaceFiller> make_model_surfaces(
    const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice,
    std::unique_ptr<const xsharp::SpanLoops> loops);

}  // namespace fixproof::player
