/// @file
/// Phong light along a row, in its three forms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "xsharp/normals.hpp"
#include "xsharp/raster/parabola.hpp"
#include "xsharp/raster/step.hpp"
#include "xsharp/raster/stretch.hpp"
#include "xsharp/surface.hpp"
#include "xsharp/surface_values.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

template <Scalar N>
struct PhongRow {
  std::array<Step<N>, 3> normal{};
  Vec3<N> light{};
  Surface surface{};

  /// PhongForm::exact: the ramp value of the normalised interpolated normal, `units` of 2^-16
  /// pixels from the first pixel.
  [[nodiscard]] N at(std::int64_t units) const {
    const Vec3<N> direction =
        unit(Vec3<N>{value_after(normal[0], units), value_after(normal[1], units),
                     value_after(normal[2], units)});
    return ramp_value(dot(light, direction), surface);
  }

  /// PhongForm::fourth, with 4 for `every`: calls draw(stretch, line).
  template <class Draw>
  void in_lines(std::size_t count, std::size_t every, const Draw& draw) const {
    in_stretches(
        count, every, [this](std::size_t pixel) { return std::array{at(units_of(pixel))}; },
        [&](const Stretch& stretch, const std::array<Step<N>, 1>& line) {
          draw(stretch, line.front());
        });
  }

  /// PhongForm::quadratic, for `count` pixels from `from` on. @param count positive
  [[nodiscard]] Parabola parabola(std::size_t from, std::size_t count) const {
    const std::int64_t first = units_of(from);
    const std::int64_t way = units_of(count - 1);
    return parabola_through(at(first), at(first + way / 2), at(first + way),
                            static_cast<std::int32_t>(count - 1));
  }
};

}  // namespace xsharp
