#include "measure/trade/drift/strip.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "measure/player/players.hpp"
#include "xsharp/raster/palette.hpp"

namespace fixproof::trade {

namespace {

constexpr int cell = 110;
constexpr int name_width = 190;
constexpr int head = 28;

/// A scene with this object alone, in front of the viewer, filling most of a cell.
xsharp::Scene alone(xsharp::Scene scene, std::size_t object) {
  xsharp::ObjectDescription kept = scene.objects.at(object);
  double radius = 0;
  for (const xsharp::Triple& v : kept.mesh.vertices) radius = std::max(radius, xsharp::length(v));
  // Scaling a body and its distance together changes only the rounding of its vertices, so any size
  // that leaves headroom in 16.16 will do.
  const std::vector<xsharp::Triple> before = kept.mesh.vertices;
  for (xsharp::Triple& v : kept.mesh.vertices) v = xsharp::scaled(v, 100 / radius);
  for (const xsharp::Face& face : kept.mesh.faces) {
    if (!face.normal_end) continue;
    const std::size_t start = face.vertices[0];
    // Normals keep unit length.
    kept.mesh.vertices[*face.normal_end] = xsharp::sum(
        kept.mesh.vertices[start], xsharp::difference(before[*face.normal_end], before[start]));
  }
  scene.projection_ratio = -2;
  scene.camera = {};
  scene.width = scene.height = cell;
  kept.page = {};
  kept.position = {0, 0, -350};
  kept.drift.reset();
  kept.orbit.reset();
  scene.objects = {std::move(kept)};
  return scene;
}

/// A nested SVG clips shapes that have grown beyond their cell.
std::string polygons(const xsharp::Picture& picture, const xsharp::Palette& palette, int x, int y) {
  std::string svg =
      fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n", x, y, cell, cell);
  for (const xsharp::Polygon& polygon : picture.polygons) {
    const xsharp::Paint& paint = polygon.paint;
    const xsharp::Color color = paint.is_index ? palette.at(paint.index) : paint.color;
    svg += "<polygon points=\"";
    for (const xsharp::ScreenPoint& point : picture.points_of(polygon)) {
      svg += fmt::format("{},{} ", point.x, point.y);
    }
    svg += fmt::format("\" fill=\"#{:02x}{:02x}{:02x}\"/>\n", color.red, color.green, color.blue);
  }
  return svg + "</svg>\n";
}

}  // namespace

std::string drift_strip(const std::vector<StripRow>& rows, std::size_t object,
                        const std::vector<std::uint64_t>& frames,
                        const std::vector<std::string>& labels) {
  const int width = name_width + cell * static_cast<int>(frames.size());
  const int height = head + cell * static_cast<int>(rows.size());
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" font-family=\"sans-serif\" font-size=\"13\">\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#14161a\"/>\n",
      width, height);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    svg += fmt::format("<text x=\"{}\" y=\"19\" fill=\"#ddd\" text-anchor=\"middle\">{}</text>\n",
                       name_width + cell * static_cast<int>(i) + cell / 2, labels[i]);
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const int top = head + cell * static_cast<int>(r);
    svg += fmt::format("<text x=\"10\" y=\"{}\" fill=\"#ddd\">{}</text>\n", top + cell / 2,
                       rows[r].name);
    const xsharp::Scene scene = alone(rows[r].scene, object);
    const auto player = player::make_player(scene, scene.arithmetic);
    const xsharp::Palette& palette = xsharp::palette_of(scene.palette);
    xsharp::Picture picture;
    std::uint64_t frame = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
      for (; frame < frames[i]; ++frame) player->move();
      player->draw(picture);
      svg += polygons(picture, palette, name_width + cell * static_cast<int>(i), top);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace fixproof::trade
