/// @file
/// Fills surfaces by stepping, in a scene's arithmetic and with the inner loops of one party.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "xsharp/raster/depth_buffer.hpp"
#include "xsharp/raster/depth_row.hpp"
#include "xsharp/raster/row_painter.hpp"
#include "xsharp/raster/stepped_rows.hpp"
#include "xsharp/raster/surface_filler.hpp"

namespace xsharp {

template <Scalar N>
class StepFiller : public SurfaceFiller {
 public:
  StepFiller(const Scene& scene, std::unique_ptr<const SpanLoops> loops)
      : SurfaceFiller(scene),
        loops_(std::move(loops)),
        painter_(*loops_),
        depths_(scene.depth_buffer) {}

  void begin(const Picture& picture, std::int32_t width, std::int32_t height) override {
    const auto number = [](double value) { return SteppedRows<N>::number(value); };
    depths_.begin(width, height);
    painter_.set_light(
        {number(picture.light[0]), number(picture.light[1]), number(picture.light[2])});
  }

 protected:
  std::span<const PixelRow> find_rows(const Picture& picture, const Polygon& polygon,
                                      const Surface& surface, std::int32_t width,
                                      std::int32_t height) override {
    return rows_.find(picture, polygon, surface, buffered(), width, height);
  }

  void draw(std::size_t index, const Surface& surface, std::span<std::uint8_t> out,
            std::uint8_t pixel, std::span<std::uint8_t> set) override {
    const PixelRow& row = rows_.row(index);
    const auto steps = rows_.steps(index);
    const auto texels = has_bitmap(surface) ? bitmap() : std::span<const std::uint8_t>{};
    if (!buffered()) {
      painter_.draw(surface, steps, texels, out);
      return;
    }
    const auto buffer = depths_.pixels(row.y, row.left, out.size());
    before_.assign(buffer.begin(), buffer.end());
    const bool constant = surface.kind == SurfaceKind::flat;
    const bool published = constant && !depths_.reversed();
    line_.assign(out.size(), pixel);
    if (!constant) painter_.draw(surface, steps, texels, line_);
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

 private:
  std::unique_ptr<const SpanLoops> loops_;
  RowPainter<N> painter_;
  DepthBuffer depths_;
  SteppedRows<N> rows_{};
  std::vector<std::uint8_t> line_{};
  std::vector<std::int16_t> before_{};
};

}  // namespace xsharp
