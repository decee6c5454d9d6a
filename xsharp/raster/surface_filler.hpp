/// @file
/// Fills the polygons of interpolated surfaces, row by row.
#pragma once

#include <algorithm>
#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "xsharp/picture.hpp"
#include "xsharp/raster/bitmap.hpp"
#include "xsharp/raster/page.hpp"
#include "xsharp/raster/palette.hpp"
#include "xsharp/raster/pixel_row.hpp"
#include "xsharp/scene.hpp"

namespace xsharp {

/// Sets the same pixels as Filler (fill.hpp), each to the value of the surface. Under a depth
/// buffer it fills all polygons, and skips pixels where something is nearer.
///
/// Derived classes compute the values. Rows are palette indices; a page of true colour gets the
/// colours for them.
class SurfaceFiller : private boost::noncopyable {
 public:
  explicit SurfaceFiller(const Scene& scene)
      : palette_(scene.palette), buffered_(scene.depth_buffer != DepthBuffering::off) {
    for (const ObjectDescription& object : scene.objects) {
      surfaces_.push_back(object.surface);
      bitmaps_.push_back(has_bitmap(object.surface) ? bitmap_of(object.surface)
                                                    : std::vector<std::uint8_t>{});
    }
  }
  virtual ~SurfaceFiller() = default;

  /// Called before the first polygon of a picture, with the size of the page.
  virtual void begin(const Picture& picture, std::int32_t width, std::int32_t height) = 0;

  /// Whether this class fills the polygon; otherwise Filler does.
  [[nodiscard]] bool fills(const Picture& picture, const Polygon& polygon) const {
    if (picture.values.size() != picture.points.size()) return false;
    return buffered_ || surface_of(polygon).kind != SurfaceKind::flat;
  }

  /// @param pixel for a flat polygon
  /// @return the number of pixels set
  template <PixelType Pixel>
  std::int64_t fill(Page<Pixel>& page, const Picture& picture, const Polygon& polygon,
                    Pixel pixel) {
    std::int64_t set = 0;
    const Surface& surface = surface_of(polygon);
    object_ = polygon.object;
    const auto rows = find_rows(picture, polygon, surface, page.width(), page.height());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const PixelRow& row = rows[i];
      const auto count = static_cast<std::size_t>(row.right - row.left);
      const auto out = page.row(row.y).subspan(static_cast<std::size_t>(row.left), count);
      set_.assign(buffered_ ? count : 0, 0);
      if constexpr (std::same_as<Pixel, std::uint8_t>) {
        draw(i, surface, out, pixel, set_);
      } else {
        line_.assign(count, 0);
        draw(i, surface, line_, 0, set_);
        const bool flat = surface.kind == SurfaceKind::flat;
        for (std::size_t x = 0; x < count; ++x) {
          if (buffered_ && set_[x] == 0) continue;
          out[x] = flat ? pixel : rgb(palette_of(palette_).at(line_[x]));
        }
      }
      set += buffered_ ? std::count(set_.begin(), set_.end(), 1) : row.right - row.left;
    }
    return set;
  }

 protected:
  [[nodiscard]] bool buffered() const { return buffered_; }

  /// The bitmap of the current polygon. @pre its surface has one
  [[nodiscard]] std::span<const std::uint8_t> bitmap() const { return bitmaps_[object_]; }

  /// The polygon's rows on the page. draw() takes an index into them, until the next call.
  virtual std::span<const PixelRow> find_rows(const Picture& picture, const Polygon& polygon,
                                              const Surface& surface, std::int32_t width,
                                              std::int32_t height) = 0;
  /// Sets the pixels of a row where nothing is nearer.
  /// @param set empty, or under a depth buffer as long as `out`: becomes 1 for each pixel set
  virtual void draw(std::size_t row, const Surface& surface, std::span<std::uint8_t> out,
                    std::uint8_t pixel, std::span<std::uint8_t> set) = 0;

 private:
  /// The surface of a polygon. Objects added to the scene's are flat.
  [[nodiscard]] const Surface& surface_of(const Polygon& polygon) const {
    static constexpr Surface flat{};
    return polygon.object < surfaces_.size() ? surfaces_[polygon.object] : flat;
  }

  PaletteKind palette_;
  bool buffered_;
  std::vector<Surface> surfaces_{};
  std::vector<std::vector<std::uint8_t>> bitmaps_{};
  std::size_t object_ = 0;
  std::vector<std::uint8_t> set_{};
  std::vector<std::uint8_t> line_{};
};

}  // namespace xsharp
