/// @file
/// Fills surfaces without stepping: computes the exact value per pixel in double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "xsharp/normals.hpp"
#include "xsharp/raster/chains.hpp"
#include "xsharp/raster/surface_filler.hpp"
#include "xsharp/surface_values.hpp"

namespace xsharp {

/// The reference, the same for every variant of a surface. Light is exact, textures are in
/// perspective, and Phong light is computed per pixel. Depths are inverses of z, compared in
/// double; the buffer is cleared before every picture. Values are still truncated to whole palette
/// indices, as in the loops.
class ExactFiller final : public SurfaceFiller {
 public:
  explicit ExactFiller(const Scene& scene)
      : SurfaceFiller(scene), gets_z_(scene.depth_measure == DepthMeasure::z) {}

  void begin(const Picture& picture, std::int32_t width, std::int32_t height) override {
    light_ = {picture.light[0], picture.light[1], picture.light[2]};
    width_ = static_cast<std::size_t>(width);
    depths_.assign(buffered() ? width_ * static_cast<std::size_t>(height) : 0,
                   -std::numeric_limits<double>::infinity());
  }

  /// The nearest depth at a pixel of the last picture under a depth buffer, or minus infinity if
  /// nothing was drawn there.
  [[nodiscard]] double depth_at(std::int32_t x, std::int32_t y) const {
    return depths_.at(static_cast<std::size_t>(y) * width_ + static_cast<std::size_t>(x));
  }

 private:
  /// The crossing of an edge with a row, and the values there.
  struct Crossing {
    double x = 0;
    PointValues values{};
  };
  struct Span {
    Crossing left{};
    Crossing right{};
  };

  static PointValues mixed(const PointValues& from, const PointValues& to, double part) {
    PointValues result{};
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = from[k] + (to[k] - from[k]) * part;
    return result;
  }

  std::span<const PixelRow> find_rows(const Picture& picture, const Polygon& polygon,
                                      const Surface& surface, std::int32_t width,
                                      std::int32_t height) override {
    rows_.clear();
    spans_.clear();
    const auto points = picture.points_of(polygon);
    const Chains chains(points);
    const std::int32_t top = chains.first();
    const std::int32_t bottom = chains.end(height);
    if (top >= bottom) return rows_;
    corners_.assign(picture.values_of(polygon).begin(), picture.values_of(polygon).end());
    for (PointValues& corner : corners_) {
      // Converts z, which is not linear on the screen, to its inverse, which is.
      if (gets_z_) corner[0] = 1 / (nearest_depth + 1 - corner[0]);
      // In perspective, value times depth is linear on the screen.
      if (surface.kind == SurfaceKind::texture) {
        corner = {corner[0], corner[1] * corner[0], corner[2] * corner[0], 0};
      }
    }
    spans_.resize(static_cast<std::size_t>(bottom - top));
    const auto store = [&](Crossing Span::*end) {
      return [&, end](const ChainEdge& edge) {
        for (std::int32_t row = edge.first; row < edge.end; ++row) {
          spans_[static_cast<std::size_t>(row - top)].*end =
              crossing(points, edge, double{1} * edge.y + (row - edge.first));
        }
      };
    };
    chains.walk(height, store(&Span::left), store(&Span::right));
    // A projected coordinate is within 2^17, so a crossing is either whole or at least 2^-18 away
    // from a whole number, which double resolves.
    const auto pixel = [width](double x) {
      return static_cast<std::int32_t>(std::clamp(std::ceil(x), 0.0, double{1} * width));
    };
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      const PixelRow row{top + static_cast<std::int32_t>(i), pixel(spans_[i].left.x),
                         pixel(spans_[i].right.x)};
      if (row.left >= row.right) continue;
      spans_[rows_.size()] = spans_[i];
      rows_.push_back(row);
    }
    return rows_;
  }

  /// The crossing of an edge with its own row `y`, and the values there.
  [[nodiscard]] Crossing crossing(std::span<const ScreenPoint> points, const ChainEdge& edge,
                                  double y) const {
    const ScreenPoint& upper = points[edge.upper];
    const ScreenPoint& lower = points[edge.lower];
    const double down = y - upper.y;
    const double rows = static_cast<double>(lower.y) - upper.y;
    const double across = static_cast<double>(lower.x) - upper.x;
    return {upper.x + across * down / rows,
            mixed(corners_[edge.upper], corners_[edge.lower], down / rows)};
  }

  void draw(std::size_t index, const Surface& surface, std::span<std::uint8_t> out,
            std::uint8_t pixel, std::span<std::uint8_t> set) override {
    const PixelRow& row = rows_[index];
    const Span& span = spans_[index];
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double x = static_cast<double>(row.left) + static_cast<double>(i);
      const double part = (x - span.left.x) / (span.right.x - span.left.x);
      const PointValues values = mixed(span.left.values, span.right.values, part);
      if (buffered()) {
        double& depth = depths_[static_cast<std::size_t>(row.y) * width_ +
                                static_cast<std::size_t>(row.left) + i];
        if (!(values[0] > depth)) continue;
        depth = values[0];
        set[i] = 1;
      }
      out[i] = color(surface, values, pixel);
    }
  }

  [[nodiscard]] std::uint8_t color(const Surface& surface, const PointValues& values,
                                   std::uint8_t pixel) const {
    // NaN becomes 0.
    const auto index = [](double value) {
      return value > 0 ? static_cast<std::uint8_t>(std::min(value, 255.0)) : std::uint8_t{0};
    };
    switch (surface.kind) {
      case SurfaceKind::flat:
        return pixel;
      case SurfaceKind::texture:
      case SurfaceKind::environment: {
        const double depth = surface.kind == SurfaceKind::texture ? values[0] : 1;
        const auto texel = [&](double value) -> std::size_t {
          return depth > 0 ? index(value / depth * 256) : 0;
        };
        return bitmap()[texel(values[2]) * 256 + texel(values[1])];
      }
      case SurfaceKind::phong:
        return index(
            ramp_value(dot(light_, unit(Vec3<double>{values[1], values[2], values[3]})), surface));
      default:
        return index(values[1]);
    }
  }

  bool gets_z_;
  Vec3<double> light_{};
  std::size_t width_ = 0;
  std::vector<double> depths_{};

  // of the current polygon
  std::vector<PointValues> corners_{};
  std::vector<PixelRow> rows_{};
  std::vector<Span> spans_{};
};

}  // namespace xsharp
