/// @file
/// Decides which objects are near enough to be drawn.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "xsharp/motion.hpp"
#include "xsharp/view.hpp"

namespace xsharp {

/// The transform of an object to the world, relative to the page where the view begins. Returns
/// nothing if some vertex could leave 16.16 in view space: the object is too far away to be drawn.
/// @param radius of the object, from the origin of its object space
template <Scalar N>
std::optional<Transform<N>> within_reach(const Motion<N>& motion, const View<N>& view,
                                         double radius) {
  Transform<N> to_world = motion.to_world();
  double distance = 0;
  double stretch = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t pages = std::int64_t{motion.page()[i]} - view.page[i];
    const double place =
        static_cast<double>(to_world.rows[i][3]) + static_cast<double>(pages) * page_size;
    if (std::fabs(place) >= 2.0 * page_size) return std::nullopt;
    // Each step is in range and exact.
    for (std::int64_t page = 0; page != pages; page += pages < 0 ? -1 : 1) {
      const N step = from_whole<N>(page_size);
      to_world.rows[i][3] = pages < 0 ? to_world.rows[i][3] - step : to_world.rows[i][3] + step;
    }
    distance += place * place;
    for (std::size_t j = 0; j < 3; ++j) {
      stretch += std::pow(static_cast<double>(to_world.rows[i][j]), 2);
    }
  }
  double viewer = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    viewer += std::pow(static_cast<double>(view.world_to_view.rows[i][3]), 2);
  }
  const bool near = std::sqrt(distance) + std::sqrt(viewer) + std::sqrt(stretch) * radius < 32767;
  return near ? std::optional(to_world) : std::nullopt;
}

}  // namespace xsharp
