/// @file
/// Fills surfaces by stepping, in a scene's arithmetic and with the inner loops of one party.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "xsharp/raster/bitmap.hpp"
#include "xsharp/raster/chains.hpp"
#include "xsharp/raster/depth_buffer.hpp"
#include "xsharp/raster/depth_row.hpp"
#include "xsharp/raster/edge.hpp"
#include "xsharp/raster/parabola.hpp"
#include "xsharp/raster/perspective_place.hpp"
#include "xsharp/raster/phong_row.hpp"
#include "xsharp/raster/span_loops.hpp"
#include "xsharp/raster/step.hpp"
#include "xsharp/raster/stretch.hpp"
#include "xsharp/raster/surface_filler.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

template <Scalar N>
class StepFiller final : public SurfaceFiller {
 public:
  StepFiller(const Scene& scene, std::unique_ptr<const SpanLoops> loops)
      : SurfaceFiller(scene), loops_(std::move(loops)), depths_(scene.depth_buffer) {}

  void begin(const Picture& picture, std::int32_t width, std::int32_t height) override {
    depths_.begin(width, height);
    light_ = {number(picture.light[0]), number(picture.light[1]), number(picture.light[2])};
  }

 private:
  using Steps = std::array<Step<N>, 4>;

  /// The crossing of an edge with a row, in 2^-16 pixels, and the values there.
  struct Crossing {
    std::int64_t units = 0;
    std::array<N, 4> values{};
  };
  struct Ends {
    Crossing left{};
    Crossing right{};
  };

  static N number(double value) {
    return Arithmetic<N>::from_raw(raw_constant(value, Conversion::nearest));
  }

  std::span<const Row> find_rows(const Picture& picture, const Polygon& polygon,
                                 const Surface& surface, std::int32_t width,
                                 std::int32_t height) override {
    rows_.clear();
    const auto points = picture.points_of(polygon);
    const Chains chains(points);
    top_ = chains.first();
    const std::int32_t bottom = chains.end(height);
    if (top_ >= bottom) return rows_;
    choose_slots(surface);
    ends_.resize(static_cast<std::size_t>(bottom - top_));
    corners_.clear();
    for (const PointValues& values : picture.values_of(polygon)) {
      corners_.push_back(corner(values, surface));
    }
    chains.walk(
        height, [&](const ChainEdge& edge) { cross(points, edge, &Ends::left); },
        [&](const ChainEdge& edge) { cross(points, edge, &Ends::right); });
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const auto left = std::max<std::int64_t>(first_pixel(ends_[i].left), 0);
      const auto right = std::min<std::int64_t>(first_pixel(ends_[i].right), width);
      if (left >= right) continue;
      rows_.push_back({top_ + static_cast<std::int32_t>(i), static_cast<std::int32_t>(left),
                       static_cast<std::int32_t>(right)});
    }
    return rows_;
  }

  /// Selects which of a point's four values are stepped.
  void choose_slots(const Surface& surface) {
    first_slot_ = buffered() || in_perspective(surface) ? 0 : 1;
    end_slot_ = surface.kind == SurfaceKind::flat    ? 1
                : has_bitmap(surface)                ? 3
                : surface.kind == SurfaceKind::phong ? 4
                                                     : 2;
  }

  /// The stepped values of a corner. In perspective, bitmap coordinates are multiplied by depth,
  /// which makes them linear on the screen.
  static std::array<N, 4> corner(const PointValues& values, const Surface& surface) {
    std::array<N, 4> numbers{number(values[0]), number(values[1]), number(values[2]),
                             number(values[3])};
    if (in_perspective(surface)) {
      numbers[1] = numbers[1] * numbers[0];
      numbers[2] = numbers[2] * numbers[0];
    }
    return numbers;
  }

  static std::int64_t first_pixel(const Crossing& crossing) {
    return (crossing.units + 65535) >> 16;
  }

  /// Stores an edge's crossings as one end of the rows that it yields.
  void cross(std::span<const ScreenPoint> points, const ChainEdge& edge, Crossing Ends::*end) {
    const ScreenPoint& upper = points[edge.upper];
    const ScreenPoint& lower = points[edge.lower];
    EdgeWalk walk(upper, lower, edge.y);
    const std::int64_t length = (std::int64_t{lower.y} - upper.y) * 65536;
    const std::int64_t skipped = (std::int64_t{edge.y} - upper.y) * 65536;
    const std::array<N, 4>& from = corners_[edge.upper];
    std::array<N, 4> values = from;
    std::array<N, 4> slopes{};
    for (std::size_t k = first_slot_; k < end_slot_; ++k) {
      slopes[k] = slope(from[k], corners_[edge.lower][k], length);
      if (skipped != 0) values[k] = from[k] + slopes[k] * distance_of<N>(skipped);
    }
    for (std::int32_t row = edge.first; row < edge.end; ++row) {
      ends_[static_cast<std::size_t>(row - top_)].*
          end = {walk.x() * 65536 - walk.to_the_left(), values};
      walk.step_down();
      for (std::size_t k = first_slot_; k < end_slot_; ++k) values[k] = values[k] + slopes[k];
    }
  }

  void draw(std::size_t index, const Surface& surface, std::span<std::uint8_t> out,
            std::uint8_t pixel, std::span<std::uint8_t> set) override {
    const Row& row = rows_[index];
    const Ends& ends = ends_[static_cast<std::size_t>(row.y - top_)];
    const std::int64_t units = ends.right.units - ends.left.units;
    const std::int64_t distance = std::int64_t{row.left} * 65536 - ends.left.units;
    Steps steps{};
    for (std::size_t k = first_slot_; k < end_slot_; ++k) {
      steps[k] = step_across(ends.left.values[k], ends.right.values[k], units, distance);
    }
    if (!buffered()) {
      color(surface, steps, out);
      return;
    }
    const auto buffer = depths_.pixels(row.y, row.left, out.size());
    before_.assign(buffer.begin(), buffer.end());
    const bool constant = surface.kind == SurfaceKind::flat;
    const bool published = constant && !depths_.reversed();
    line_.assign(out.size(), pixel);
    if (!constant) color(surface, steps, line_);
    in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
      const StepWords words = depths_.words(step_from(steps[0], from));
      const auto piece = out.subspan(from, count);
      const auto depths = buffer.subspan(from, count);
      if (published) {
        loops_->depth(piece, depths, pixel, words.start, words.step);
      } else {
        depth_row(piece, depths, std::span(line_).subspan(from, count), words, depths_.reversed());
      }
    });
    // Compares the depths before and after to find the pixels that were set.
    for (std::size_t x = 0; x < out.size(); ++x) set[x] = before_[x] == buffer[x] ? 0 : 1;
  }

  void color(const Surface& surface, const Steps& steps, std::span<std::uint8_t> out) const {
    switch (surface.kind) {
      case SurfaceKind::flat:
        return;
      case SurfaceKind::gouraud16:
        in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
          const StepWords words = words_of(step_from(steps[1], from), 0);
          loops_->gouraud_wide(out.subspan(from, count), words.start, words.step);
        });
        return;
      case SurfaceKind::gouraud8:
      case SurfaceKind::depth:
      case SurfaceKind::distance:
        in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
          const StepWords words = words_of(step_from(steps[1], from), dropped_bits);
          loops_->gouraud(out.subspan(from, count), static_cast<std::uint16_t>(words.start),
                          static_cast<std::uint16_t>(words.step));
        });
        return;
      case SurfaceKind::texture:
      case SurfaceKind::environment:
        texture(surface, steps, out);
        return;
      case SurfaceKind::phong:
        phong(surface, steps, out);
        return;
    }
  }

  void texture(const Surface& surface, const Steps& steps, std::span<std::uint8_t> out) const {
    // 1 is 256 texels, so a number in 16.16 is the loop's texels in 8.8.
    const auto run = [&](std::span<std::uint8_t> piece, const Step<N>& u, const Step<N>& v) {
      const StepWords across = inside_bitmap(words_of(u, 0), piece.size());
      const StepWords down = inside_bitmap(words_of(v, 0), piece.size());
      loops_->texture(piece, bitmap(), across.start, across.step, down.start, down.step);
    };
    if (!in_perspective(surface)) {
      in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
        run(out.subspan(from, count), step_from(steps[1], from), step_from(steps[2], from));
      });
      return;
    }
    const PerspectivePlace<N, 2> place{{steps[1], steps[2]}, steps[0]};
    in_stretches(
        out.size(), static_cast<std::size_t>(surface.exact_every),
        [&](std::size_t pixel) { return place.at(pixel); },
        [&](const Stretch& stretch, const std::array<Step<N>, 2>& lines) {
          run(out.subspan(stretch.from, stretch.count), lines[0], lines[1]);
        });
  }

  void phong(const Surface& surface, const Steps& steps, std::span<std::uint8_t> out) const {
    const PhongRow<N> row{{steps[1], steps[2], steps[3]}, light_, surface};
    switch (surface.phong) {
      case PhongForm::exact:
        for (std::size_t x = 0; x < out.size(); ++x) {
          const auto word = static_cast<std::uint32_t>(Arithmetic<N>::raw(row.at(units_of(x))));
          out[x] = static_cast<std::uint8_t>(word >> 16U);
        }
        return;
      case PhongForm::fourth:
        row.in_lines(out.size(), 4, [&](const Stretch& stretch, const Step<N>& line) {
          const StepWords words = words_of(line, 0);
          loops_->gouraud_wide(out.subspan(stretch.from, stretch.count), words.start, words.step);
        });
        return;
      case PhongForm::quadratic:
        in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
          quadratic(out.subspan(from, count), row.parabola(from, count));
        });
        return;
    }
  }

  std::unique_ptr<const SpanLoops> loops_;
  DepthBuffer depths_;
  Vec3<N> light_{};

  // of the current polygon
  std::size_t first_slot_ = 0;
  std::size_t end_slot_ = 0;
  std::int32_t top_ = 0;
  std::vector<std::array<N, 4>> corners_{};
  std::vector<Ends> ends_{};
  std::vector<Row> rows_{};
  std::vector<std::uint8_t> line_{};
  std::vector<std::int16_t> before_{};
};

}  // namespace xsharp
