/// @file
/// Blinn's highlights on faces.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "xsharp/arithmetic.hpp"
#include "xsharp/picture.hpp"
#include "xsharp/scene.hpp"
#include "xsharp/shade.hpp"
#include "xsharp/transform.hpp"
#include "xsharp/unit_vector.hpp"

namespace xsharp {

/// The cosine of the angle between a normal and the vector halfway between light and viewer, at
/// most 1. The vectors have unit length.
template <Scalar N>
N halfway_cosine(const Vec3<N>& normal, const Vec3<N>& to_light, const Vec3<N>& to_viewer) {
  return std::min(dot(unit_vector(to_light + to_viewer), normal), from_whole<N>(1));
}

/// A colour with the highlights of all lights that are on and in front of the face. Each light's
/// intensity is multiplied by strength * cosine^exponent, and the sum by 255; every product is
/// rounded as the multiply rounds. A highlight has the colour of the light, whatever the face
/// reflects.
/// @param normal    a unit vector in view space
/// @param to_viewer a unit vector from the face
template <Scalar N>
Color with_highlight(const Color& color, const Vec3<N>& normal, const Vec3<N>& to_viewer,
                     const Highlight& highlight, const Lighting<N>& lighting) {
  const N zero = from_whole<N>(0);
  const N exponent = Arithmetic<N>::constant(highlight.exponent, Conversion::nearest);
  const N strength = Arithmetic<N>::constant(highlight.strength, Conversion::nearest);
  std::array<N, 3> light{zero, zero, zero};
  for (const Ray<N>& ray : lighting.rays) {
    if (!ray.on || !(zero < dot(ray.to_light, normal))) continue;
    const N cosine = halfway_cosine(normal, ray.to_light, to_viewer);
    if (!(zero < cosine)) continue;
    const N part = strength * Arithmetic<N>::power(cosine, exponent);
    for (std::size_t c = 0; c < 3; ++c) light[c] = light[c] + ray.intensity[c] * part;
  }
  const auto component = [&light](std::size_t c, std::uint8_t without) {
    const N added = Arithmetic<N>::from_raw(255) * light[c];
    return static_cast<std::uint8_t>(std::min(without + Arithmetic<N>::raw(added), 255));
  };
  return {component(0, color.red), component(1, color.green), component(2, color.blue)};
}

}  // namespace xsharp
