#include "measure/player/beside_exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "measure/player/surfaces.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "xsharp/files/png.hpp"
#include "xsharp/raster/fill.hpp"
#include "xsharp/raster/palette.hpp"

namespace fixproof::player {

namespace {

using Indices = xsharp::Page<std::uint8_t>;

void draw_surfaces(const xsharp::Picture& picture, xsharp::SurfaceFiller& surfaces,
                   xsharp::PaletteKind palette, std::uint8_t background, Indices& page) {
  xsharp::Filler flat;
  page.clear(background);
  surfaces.begin(picture, page.width(), page.height());
  for (const xsharp::Polygon& polygon : picture.polygons) {
    const auto pixel = xsharp::pixel_of<std::uint8_t>(polygon.paint, palette);
    if (surfaces.fills(picture, polygon)) {
      surfaces.fill(page, picture, polygon, pixel);
    } else {
      flat.fill(page, picture.points_of(polygon), pixel);
    }
  }
}

/// Black for equal indices, lighter for larger differences, white from a difference of three.
std::uint32_t shade_of_difference(int apart) {
  if (apart == 0) return 0;
  return std::min(63U + 64U * static_cast<std::uint32_t>(apart), 255U) * 0x010101U;
}

}  // namespace

BesideExact::BesideExact(const xsharp::Scene& scene, const std::string& file)
    : palette_(scene.palette),
      file_(file),
      stepper_(make_surfaces(scene, scene.arithmetic)),
      exact_filler_(scene),
      background_(scene.background),
      stepped_(scene.width, scene.height),
      exact_(scene.width, scene.height) {
  if (!stepper_)
    throw support::UsageError("--beside: the scene has no interpolated surface; add --surface");
  if (scene.arithmetic.by == "double") {
    throw support::UsageError("--beside compares with double; choose another --arith");
  }
}

void BesideExact::show(const xsharp::Picture& picture) {
  ++pictures_;
  draw_surfaces(picture, *stepper_, palette_, background_, stepped_);
  draw_surfaces(picture, exact_filler_, palette_, background_, exact_);
  const auto exact = std::as_const(exact_).pixels();
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const int apart = std::abs(stepped_.pixels()[i] - exact[i]);
    differing_ += apart == 0 ? 0 : 1;
    max_difference_ = std::max(max_difference_, apart);
  }
}

void BesideExact::finish() {
  if (pictures_ > 0) file_.replace(png());
}

std::string BesideExact::differences() const {
  if (pictures_ == 0) return "";
  return fmt::format("{} of {} pixels differ, indices of the palette by {} at most",
                     support::grouped(differing_),
                     support::grouped(pictures_ * exact_.pixels().size()), max_difference_);
}

std::string BesideExact::png() const {
  constexpr std::size_t gap = 4;
  const auto width = static_cast<std::size_t>(exact_.width());
  const xsharp::Palette& colors = xsharp::palette_of(palette_);
  xsharp::Page<std::uint32_t> all(static_cast<std::int32_t>(3 * width + 2 * gap), exact_.height());
  all.clear(0xFFFFFF);
  for (std::int32_t y = 0; y < exact_.height(); ++y) {
    const auto row = all.row(y);
    for (std::size_t x = 0; x < width; ++x) {
      const std::uint8_t is = stepped_.row(y)[x];
      const std::uint8_t should_be = exact_.row(y)[x];
      row[x] = xsharp::rgb(colors.at(is));
      row[width + gap + x] = xsharp::rgb(colors.at(should_be));
      row[2 * (width + gap) + x] = shade_of_difference(std::abs(is - should_be));
    }
  }
  return xsharp::encode_png(all);
}

}  // namespace fixproof::player
