/// @file
/// Ambient and diffuse (Lambert) light on a face, per colour component.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "xsharp/arithmetic.hpp"
#include "xsharp/picture.hpp"
#include "xsharp/scene.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// A distant light with parallel rays.
template <Scalar N>
struct Ray {
  bool on = true;
  /// The unit vector towards the light, in view space.
  Vec3<N> to_light{};
  /// Red, green, blue.
  std::array<N, 3> intensity{};
  /// The mean of the three, for surfaces that show light on a ramp.
  N level{};
};

template <Scalar N>
struct Lighting {
  bool ambient_on = true;
  std::array<N, 3> ambient{};
  std::vector<Ray<N>> rays;
};

/// The lights of a scene in the number type.
///
/// The steps for a direction are the published ones. Its components, including whole ones, are
/// converted as constants. It is normalised in double, converted again, rotated into view space,
/// and only then negated. The published conversion is one unit too high for negative values, so the
/// order determines the last bit.
/// @param to_view its matrix rotates world space into view space; directions have no position
template <Scalar N>
Lighting<N> lighting_of(const Lights& lights, Conversion conversion, Transform<N> to_view) {
  const auto constant = [conversion](double x) { return Arithmetic<N>::constant(x, conversion); };
  const auto numbers = [conversion](const Triple& t) {
    return std::array<N, 3>{coordinate<N>(t[0], conversion), coordinate<N>(t[1], conversion),
                            coordinate<N>(t[2], conversion)};
  };
  Lighting<N> lighting{lights.ambient_on, numbers(lights.ambient), {}};
  for (auto& row : to_view.rows) row[3] = from_whole<N>(0);
  for (const Spot& spot : lights.spots) {
    Triple direction = spot.direction;
    for (double& d : direction) d = static_cast<double>(constant(d));
    const Triple unit = scaled(direction, 1 / length(direction));
    const Vec3<N> view =
        Arithmetic<N>::apply(to_view, {constant(unit[0]), constant(unit[1]), constant(unit[2])});
    lighting.rays.push_back({spot.on,
                             {-view.x, -view.y, -view.z},
                             numbers(spot.intensity),
                             Arithmetic<N>::constant(level_of(spot), Conversion::nearest)});
  }
  return lighting;
}

/// The vector whose dot product with a normal is its light on a ramp: the sum of the vectors to the
/// lights that are on, each times its level. A negative light reduces the light of others.
template <Scalar N>
Vec3<N> light_vector(const Lighting<N>& lighting) {
  const N zero = from_whole<N>(0);
  Vec3<N> sum{zero, zero, zero};
  for (const Ray<N>& ray : lighting.rays) {
    if (ray.on) sum = sum + ray.to_light * ray.level;
  }
  return sum;
}

/// The colour of a face: min(1, (ambient + sum of intensity * max(0, L . N)) * reflectance) in each
/// component, in 255ths.
///
/// Chapter 54 does not print the last step. This follows X-Sharp's program: it sums the light, then
/// multiplies it once by the reflectance, expressed as that many units of 2^-16. The result is in
/// 255ths and rounded as the multiply rounds; unrounded builds floor or truncate it.
/// @param normal      a unit vector in view space
/// @param reflectance 255 for 1
template <Scalar N>
Color shade(const Vec3<N>& normal, const Color& reflectance, const Shading& shading,
            const Lighting<N>& lighting) {
  const N zero = from_whole<N>(0);
  std::array<N, 3> light{zero, zero, zero};
  if (shading.ambient && lighting.ambient_on) light = lighting.ambient;
  if (shading.diffuse) {
    for (const Ray<N>& ray : lighting.rays) {
      if (!ray.on) continue;
      const N cosine = dot(ray.to_light, normal);
      if (!(zero < cosine)) continue;
      for (std::size_t c = 0; c < 3; ++c) light[c] = light[c] + ray.intensity[c] * cosine;
    }
  }
  const auto component = [&light](std::size_t c, std::uint8_t full) {
    const N reflected = Arithmetic<N>::from_raw(full) * light[c];
    return static_cast<std::uint8_t>(std::min(Arithmetic<N>::raw(reflected), 255));
  };
  return {component(0, reflectance.red), component(1, reflectance.green),
          component(2, reflectance.blue)};
}

}  // namespace xsharp
