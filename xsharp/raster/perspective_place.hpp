/// @file
/// Bitmap coordinates in perspective.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "xsharp/raster/step.hpp"
#include "xsharp/raster/stretch.hpp"
#include "xsharp/ratio.hpp"

namespace xsharp {

/// K coordinates along a row. They are not linear on the screen, but depth and coordinate times
/// depth are.
template <Scalar N, std::size_t K>
struct PerspectivePlace {
  std::array<Step<N>, K> products{};
  Step<N> depth{};

  [[nodiscard]] std::array<N, K> at(std::size_t pixel) const {
    const std::int64_t units = units_of(pixel);
    const N divisor = value_after(depth, units);
    std::array<N, K> place{};
    for (std::size_t i = 0; i < K; ++i) place[i] = ratio(value_after(products[i], units), divisor);
    return place;
  }
};

}  // namespace xsharp
