/// @file
/// Draws the pixels of one row of a surface from stepped values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "xsharp/raster/bitmap.hpp"
#include "xsharp/raster/parabola.hpp"
#include "xsharp/raster/perspective_place.hpp"
#include "xsharp/raster/phong_row.hpp"
#include "xsharp/raster/span_loops.hpp"
#include "xsharp/raster/stretch.hpp"
#include "xsharp/surface.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

template <Scalar N>
class RowPainter {
 public:
  using Steps = std::array<Step<N>, 4>;

  /// @param loops must outlive the painter
  explicit RowPainter(const SpanLoops& loops) : loops_(loops) {}

  /// Sets the light for Phong surfaces; see Picture::light.
  void set_light(const Vec3<N>& light) { light_ = light; }

  /// Draws palette indices; leaves a flat row unchanged.
  /// @param bitmap of the surface, if it has one
  void draw(const Surface& surface, const Steps& steps, std::span<const std::uint8_t> bitmap,
            std::span<std::uint8_t> out) const {
    switch (surface.kind) {
      case SurfaceKind::flat:
        return;
      case SurfaceKind::gouraud16:
        in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
          const StepWords words = words_of(step_from(steps[1], from), 0);
          loops_.gouraud_wide(out.subspan(from, count), words.start, words.step);
        });
        return;
      case SurfaceKind::gouraud8:
      case SurfaceKind::depth:
      case SurfaceKind::distance:
        in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
          const StepWords words = words_of(step_from(steps[1], from), dropped_bits);
          loops_.gouraud(out.subspan(from, count), static_cast<std::uint16_t>(words.start),
                         static_cast<std::uint16_t>(words.step));
        });
        return;
      case SurfaceKind::texture:
      case SurfaceKind::environment:
        texture(surface, steps, bitmap, out);
        return;
      case SurfaceKind::phong:
        phong(surface, steps, out);
        return;
    }
  }

 private:
  void texture(const Surface& surface, const Steps& steps, std::span<const std::uint8_t> bitmap,
               std::span<std::uint8_t> out) const {
    // 1 is 256 texels, so a number in 16.16 is the loop's texels in 8.8.
    const auto run = [&](std::span<std::uint8_t> piece, const Step<N>& u, const Step<N>& v) {
      const StepWords across = inside_bitmap(words_of(u, 0), piece.size());
      const StepWords down = inside_bitmap(words_of(v, 0), piece.size());
      loops_.texture(piece, bitmap, across.start, across.step, down.start, down.step);
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
          loops_.gouraud_wide(out.subspan(stretch.from, stretch.count), words.start, words.step);
        });
        return;
      case PhongForm::quadratic:
        in_pieces(out.size(), [&](std::size_t from, std::size_t count) {
          quadratic(out.subspan(from, count), row.parabola(from, count));
        });
        return;
    }
  }

  const SpanLoops& loops_;
  Vec3<N> light_{};
};

}  // namespace xsharp
