/// @file
/// Double buffering: one page is shown while the next picture is drawn on the other.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "xsharp/picture.hpp"
#include "xsharp/raster/fill.hpp"
#include "xsharp/raster/page.hpp"
#include "xsharp/raster/palette.hpp"
#include "xsharp/raster/surface_filler.hpp"
#include "xsharp/scene.hpp"

namespace xsharp {

/// The pixels from (left, top) to (right - 1, bottom - 1).
struct Rectangle {
  std::int32_t left = 0;
  std::int32_t top = 0;
  std::int32_t right = 0;
  std::int32_t bottom = 0;
};

/// Totals of everything drawn so far.
struct DrawingCount {
  std::int64_t polygons = 0;
  std::int64_t pixels = 0;         ///< set by polygons on the page, counted each time
  std::int64_t erased_pixels = 0;  ///< reset to the background before drawing
};

/// Shows pictures one after another, each as if on an empty page, but erases only the areas of the
/// objects in the page's previous picture.
template <PixelType Pixel>
class Screen {
 public:
  /// Fills both pages with `background`, a palette index.
  /// @param surfaces fills interpolated polygons, and must outlive the screen; null draws all as
  /// flat
  /// @throws std::invalid_argument as Page does
  Screen(std::int32_t width, std::int32_t height, PaletteKind palette, std::uint8_t background,
         SurfaceFiller* surfaces = nullptr)
      : palette_(palette),
        background_(pixel_of<Pixel>(Paint{.index = background}, palette)),
        surfaces_(surfaces),
        pages_{Page<Pixel>(width, height), Page<Pixel>(width, height)} {
    for (Page<Pixel>& page : pages_) page.clear(background_);
  }

  /// Draws the picture on the hidden page and flips.
  /// @throws std::out_of_range, before drawing, if a polygon refers to points that do not exist
  void show(const Picture& picture) {
    check(picture);
    const std::size_t hidden = 1 - shown_;
    erase(pages_.at(hidden), drawn_.at(hidden));
    drawn_.at(hidden).clear();
    Page<Pixel>& page = pages_.at(hidden);
    if (surfaces_ != nullptr) surfaces_->begin(picture, page.width(), page.height());
    for (const Polygon& polygon : picture.polygons) {
      const auto points = picture.points_of(polygon);
      remember(drawn_.at(hidden), polygon.object, points);
      const auto pixel = pixel_of<Pixel>(polygon.paint, palette_);
      const bool interpolated = surfaces_ != nullptr && surfaces_->fills(picture, polygon);
      count_.pixels += interpolated ? surfaces_->fill(page, picture, polygon, pixel)
                                    : filler_.fill(page, points, pixel);
    }
    count_.polygons += static_cast<std::int64_t>(picture.polygons.size());
    shown_ = hidden;
  }

  /// The last picture shown; the next show() switches to the other page.
  [[nodiscard]] const Page<Pixel>& page() const { return pages_.at(shown_); }

  [[nodiscard]] const DrawingCount& count() const { return count_; }

 private:
  struct Drawn {
    std::uint32_t object = 0;
    Rectangle extent{};
  };

  static void check(const Picture& picture) {
    const std::size_t has = picture.points.size();
    for (const Polygon& polygon : picture.polygons) {
      if (polygon.first <= has && polygon.points <= has - polygon.first) continue;
      throw std::out_of_range("a polygon of object " + std::to_string(polygon.object) + " has " +
                              std::to_string(polygon.points) + " points from " +
                              std::to_string(polygon.first) + ", the picture has " +
                              std::to_string(has));
    }
  }

  void erase(Page<Pixel>& page, const std::vector<Drawn>& drawn) {
    for (const Drawn& object : drawn) {
      const auto left = static_cast<std::size_t>(object.extent.left);
      const auto width = static_cast<std::size_t>(object.extent.right - object.extent.left);
      for (std::int32_t y = object.extent.top; y < object.extent.bottom; ++y) {
        const std::span<Pixel> pixels = page.row(y).subspan(left, width);
        std::fill(pixels.begin(), pixels.end(), background_);
        count_.erased_pixels += static_cast<std::int64_t>(width);
      }
    }
  }

  /// Adds the polygon's extent to that of its object. If the polygons of an object are not
  /// adjacent, it has one rectangle per run, which avoids a search and erases no more.
  void remember(std::vector<Drawn>& drawn, std::uint32_t object,
                std::span<const ScreenPoint> points) const {
    const Rectangle extent = extent_of(points);
    if (extent.left >= extent.right || extent.top >= extent.bottom) return;
    if (drawn.empty() || drawn.back().object != object) {
      drawn.push_back({object, extent});
      return;
    }
    Rectangle& whole = drawn.back().extent;
    whole = {std::min(whole.left, extent.left), std::min(whole.top, extent.top),
             std::max(whole.right, extent.right), std::max(whole.bottom, extent.bottom)};
  }

  /// The bounding box on the page. It excludes the greatest coordinates, where a polygon has no
  /// pixels.
  [[nodiscard]] Rectangle extent_of(std::span<const ScreenPoint> points) const {
    const std::int32_t width = pages_.front().width();
    const std::int32_t height = pages_.front().height();
    Rectangle extent{width, height, 0, 0};
    for (const ScreenPoint& point : points) {
      extent.left = std::min(extent.left, std::max(point.x, 0));
      extent.top = std::min(extent.top, std::max(point.y, 0));
      extent.right = std::max(extent.right, std::min(point.x, width));
      extent.bottom = std::max(extent.bottom, std::min(point.y, height));
    }
    return extent;
  }

  PaletteKind palette_;
  Pixel background_;
  SurfaceFiller* surfaces_;
  std::array<Page<Pixel>, 2> pages_;
  std::array<std::vector<Drawn>, 2> drawn_{};
  std::size_t shown_ = 0;
  Filler filler_{};
  DrawingCount count_{};
};

}  // namespace xsharp
