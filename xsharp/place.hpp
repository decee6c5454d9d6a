/// @file
/// Transforms vertices to view space, and projects the corners of faces to the screen.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "fixed/batch/batch.hpp"
#include "xsharp/clip.hpp"
#include "xsharp/project.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// The outputs for vertices, one entry each.
template <Scalar N>
struct Places {
  std::span<Vec3<N>> view;
  /// Empty for a vertex outside the clip volume, or if its divide faults.
  std::span<std::optional<ScreenPoint>> screen;

  [[nodiscard]] Places part(std::size_t first, std::size_t count) const {
    return {view.subspan(first, count), screen.subspan(first, count)};
  }
};

/// Counts of the vertices that are not on the screen.
struct Unplaced {
  std::uint64_t outside = 0;  ///< outside the clip volume
  std::uint64_t faults = 0;   ///< inside, but the divide faults

  friend bool operator==(const Unplaced&, const Unplaced&) = default;
};

/// Places vertices one by one, in any arithmetic.
template <Scalar N>
Unplaced place_each(const Transform<N>& to_view, std::span<const Vec3<N>> vertices,
                    const Projection<N>& projection, const Places<N>& places) {
  Unplaced unplaced;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec3<N> place = Arithmetic<N>::apply(to_view, vertices[i]);
    places.view[i] = place;
    if (!inside(place, projection.slope)) {
      places.screen[i] = std::nullopt;
      ++unplaced.outside;
      continue;
    }
    places.screen[i] = project(place, projection);
    if (!places.screen[i]) ++unplaced.faults;
  }
  return unplaced;
}

/// Places vertices with fixed/batch/batch.hpp, in blocks that fit the first-level cache, to the
/// same bits. Vertices that a batch marks are recomputed one by one, so that they fault, saturate
/// or throw as the type does.
template <fixproof::policy P>
Unplaced place_in_batches(const Transform<fixproof::number<std::int32_t, 16, P>>& to_view,
                          std::span<const Vec3<fixproof::number<std::int32_t, 16, P>>> vertices,
                          const Projection<fixproof::number<std::int32_t, 16, P>>& projection,
                          const Places<fixproof::number<std::int32_t, 16, P>>& places) {
  using N = fixproof::number<std::int32_t, 16, P>;
  constexpr std::size_t block = 256;
  std::array<std::array<N, 2>, block> points;
  std::array<bool, block> marks{};
  Unplaced unplaced;
  for (std::size_t first = 0; first < vertices.size(); first += block) {
    const auto from = vertices.subspan(first, std::min(block, vertices.size() - first));
    const Places<N> to = places.part(first, from.size());
    const fixproof::batch::options marked{.marks = marks};
    if (!fixproof::batch::transform(to_view.rows, from, to.view, marked).clean()) {
      const Unplaced some = place_each(to_view, from, projection, to);
      unplaced.outside += some.outside;
      unplaced.faults += some.faults;
      continue;
    }
    const bool clean =
        fixproof::batch::project(to.view, projection.constant, points, marked).clean();
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (!inside(to.view[i], projection.slope)) {
        to.screen[i] = std::nullopt;
        ++unplaced.outside;
      } else if (clean || !marks[i]) {
        to.screen[i] = on_page(Projected<N>{points[i][0], points[i][1]}, projection);
      } else {
        to.screen[i] = project(to.view[i], projection);
        if (!to.screen[i]) ++unplaced.faults;
      }
    }
  }
  return unplaced;
}

/// Transforms only to view space: ends of normals are invisible and need no divides.
template <Scalar N>
void transform_to_view(const Transform<N>& to_view, std::span<const Vec3<N>> points,
                       std::span<Vec3<N>> view) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    view[i] = Arithmetic<N>::apply(to_view, points[i]);
  }
}
template <fixproof::policy P>
void transform_to_view(const Transform<fixproof::number<std::int32_t, 16, P>>& to_view,
                       std::span<const Vec3<fixproof::number<std::int32_t, 16, P>>> points,
                       std::span<Vec3<fixproof::number<std::int32_t, 16, P>>> view) {
  fixproof::batch::transform(to_view.rows, points, view);
}

/// Uses batches if the arithmetic is the type.
template <Scalar N>
Unplaced place(const Transform<N>& to_view, std::span<const Vec3<N>> vertices,
               const Projection<N>& projection, const Places<N>& places) {
  return place_each(to_view, vertices, projection, places);
}
template <fixproof::policy P>
Unplaced place(const Transform<fixproof::number<std::int32_t, 16, P>>& to_view,
               std::span<const Vec3<fixproof::number<std::int32_t, 16, P>>> vertices,
               const Projection<fixproof::number<std::int32_t, 16, P>>& projection,
               const Places<fixproof::number<std::int32_t, 16, P>>& places) {
  return place_in_batches(to_view, vertices, projection, places);
}

}  // namespace xsharp
