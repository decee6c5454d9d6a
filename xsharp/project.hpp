/// @file
/// Perspective projection, from view space to the screen.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "xsharp/arithmetic.hpp"
#include "xsharp/picture.hpp"
#include "xsharp/scene.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// How view space is seen: x and y over z, times a constant, about the middle of the page.
template <Scalar N>
struct Projection {
  /// Negative, for visible z is.
  N constant{};
  std::int32_t center_x = 0;
  std::int32_t center_y = 0;
  /// Points with |x| or |y| above slope * |z| are clipped: x / z times the constant would come near
  /// the ends of 16.16. A power of two, at least 1; see projection_of().
  std::int32_t slope = 1;
};

/// The constant is ratio * half the width, the same for x and y.
///
/// The slope is the greatest power of two, to 1024, that keeps slope * |constant| within 16,000:
/// the 8088 divide drops the divisor's fraction, which makes a quotient twice as large at most, so
/// that every projected coordinate stays within 32,000.
template <Scalar N>
Projection<N> projection_of(const Scene& scene) {
  const double constant = scene.projection_ratio *
                          (scene.width / 2);  // NOLINT(bugprone-integer-division): as published
  Projection<N> p{Arithmetic<N>::constant(constant, scene.conversion), scene.width / 2,
                  scene.height / 2, 1024};
  while (p.slope > 1 && p.slope * std::fabs(constant) > 16000) p.slope /= 2;
  return p;
}

/// A place on the screen before it is brought to pixels: from the middle of the page, y up.
template <Scalar N>
struct Projected {
  N x{};
  N y{};
};

/// Where a point of view space is seen; nothing where the divide faults, which it does not for what
/// clip() leaves.
template <Scalar N>
std::optional<Projected<N>> project_unrounded(const Vec3<N>& view,
                                              const Projection<N>& projection) {
  const auto x = Arithmetic<N>::divide(view.x, view.z);
  const auto y = Arithmetic<N>::divide(view.y, view.z);
  if (!x || !y) return std::nullopt;
  return Projected<N>{*x * projection.constant, *y * projection.constant};
}

/// Such a place in pixels of the page, y down.
template <Scalar N>
ScreenPoint on_page(const Projected<N>& place, const Projection<N>& projection) {
  return {nearest_pixel(place.x) + projection.center_x,
          -nearest_pixel(place.y) + projection.center_y};
}

/// Both in one.
template <Scalar N>
std::optional<ScreenPoint> project(const Vec3<N>& view, const Projection<N>& projection) {
  const auto place = project_unrounded(view, projection);
  if (!place) return std::nullopt;
  return on_page(*place, projection);
}

}  // namespace xsharp
