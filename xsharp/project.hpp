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

/// The projection: x and y over z, times a constant, from the middle of the page.
template <Scalar N>
struct Projection {
  /// Negative, because visible z is.
  N constant{};
  std::int32_t center_x = 0;
  std::int32_t center_y = 0;
  /// Points with |x| or |y| above slope * |z| are clipped, because x / z times the constant would
  /// approach the ends of 16.16. A power of two, at least 1; see projection_of().
  std::int32_t slope = 1;
};

/// The constant is ratio * half the width, for both x and y.
///
/// The slope is the greatest power of two, at most 1024, that keeps slope * |constant| within
/// 16,000. The 8088 divide drops the divisor's fraction, which at most doubles a quotient, so every
/// projected coordinate stays within 32,000.
template <Scalar N>
Projection<N> projection_of(const Scene& scene) {
  const double constant = scene.projection_ratio *
                          (scene.width / 2);  // NOLINT(bugprone-integer-division): as published
  Projection<N> p{Arithmetic<N>::constant(constant, scene.conversion), scene.width / 2,
                  scene.height / 2, 1024};
  while (p.slope > 1 && p.slope * std::fabs(constant) > 16000) p.slope /= 2;
  return p;
}

/// A position on the screen before rounding to pixels: from the middle of the page, y up.
template <Scalar N>
struct Projected {
  N x{};
  N y{};
};

/// Projects a point of view space. Returns nothing on a divide error, which does not occur after
/// clipping.
template <Scalar N>
std::optional<Projected<N>> project_unrounded(const Vec3<N>& view,
                                              const Projection<N>& projection) {
  const auto x = Arithmetic<N>::divide(view.x, view.z);
  const auto y = Arithmetic<N>::divide(view.y, view.z);
  if (!x || !y) return std::nullopt;
  return Projected<N>{*x * projection.constant, *y * projection.constant};
}

/// Rounds a position to pixels of the page, y down.
template <Scalar N>
ScreenPoint on_page(const Projected<N>& place, const Projection<N>& projection) {
  return {nearest_pixel(place.x) + projection.center_x,
          -nearest_pixel(place.y) + projection.center_y};
}

/// project_unrounded() and on_page() in one.
template <Scalar N>
std::optional<ScreenPoint> project(const Vec3<N>& view, const Projection<N>& projection) {
  const auto place = project_unrounded(view, projection);
  if (!place) return std::nullopt;
  return on_page(*place, projection);
}

}  // namespace xsharp
