// Filling polygons of few and of many pixels beside memset of as many, and whole frames of a ball
// with 36 faces, over a fifth to a quarter of a page of 320 x 240, with what is erased before them.
// What is drawn is held first against where the corners are: pixels of the page, not what the
// filler says of them. memset needs no check.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <numbers>
#include <span>
#include <vector>

#include "xsharp/picture.hpp"
#include "xsharp/raster/fill.hpp"
#include "xsharp/raster/page.hpp"
#include "xsharp/raster/screen.hpp"

namespace {

using xsharp::Page;
using xsharp::Picture;
using xsharp::ScreenPoint;

constexpr std::int32_t width = 320;
constexpr std::int32_t height = 240;
/// Of the page for single polygons.
constexpr std::int32_t side = 2048;

/// The near half of a ball in six rings of six faces, at the phase of its way to and fro.
Picture ball(double phase) {
  constexpr int rings = 6;
  const auto corner = [phase](int up, int round) {
    const auto angle = [](int part) { return std::numbers::pi * (part - rings / 2.0) / rings; };
    const double x = 160 + 60 * std::sin(phase) + 80 * std::cos(angle(up)) * std::sin(angle(round));
    const double y = 120 + 80 * std::sin(angle(up));
    return ScreenPoint{static_cast<std::int32_t>(std::lround(x)),
                       static_cast<std::int32_t>(std::lround(y))};
  };
  Picture picture;
  for (int up = 0; up < rings; ++up) {
    for (int round = 0; round < rings; ++round) {
      picture.polygons.push_back(
          {.object = 0,
           .first = static_cast<std::uint32_t>(picture.points.size()),
           .points = 4,
           .paint = {.is_index = true, .index = static_cast<std::uint8_t>(64 + up + round)}});
      for (const ScreenPoint& point : {corner(up, round), corner(up, round + 1),
                                       corner(up + 1, round + 1), corner(up + 1, round)}) {
        picture.points.push_back(point);
      }
    }
  }
  return picture;
}

/// A regular polygon around the middle of the page.
std::vector<ScreenPoint> disk(double radius) {
  std::vector<ScreenPoint> points;
  for (int i = 0; i < 8; ++i) {
    const double angle = std::numbers::pi * (2 * i + 1) / 8;
    points.push_back(
        {static_cast<std::int32_t>(std::lround(side / 2.0 + radius * std::cos(angle))),
         static_cast<std::int32_t>(std::lround(side / 2.0 + radius * std::sin(angle)))});
  }
  return points;
}

/// How far inside an edge of a polygon a pixel is: x right + y down + offset.
struct Edge {
  double right, down, offset;
};

std::vector<Edge> edges_of(std::span<const ScreenPoint> points) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ScreenPoint& a = points[i];
    const ScreenPoint& b = points[(i + 1) % points.size()];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double right = (a.y - b.y) / length;
    const double down = (b.x - a.x) / length;
    edges.push_back({right, down, -(a.x * right + a.y * down)});
  }
  return edges;
}

/// Whether the pixels inside are set and those outside are not; on the edge they may be either.
template <class Pixel>
bool is_filled(const Page<Pixel>& page, std::span<const ScreenPoint> points, Pixel pixel) {
  const auto edges = edges_of(points);
  for (std::int32_t y = 0; y < side; ++y) {
    const auto row = page.row(y);
    for (std::int32_t x = 0; x < side; ++x) {
      double inside = side;
      for (const Edge& edge : edges) {
        inside = std::min(inside, x * edge.right + y * edge.down + edge.offset);
      }
      const bool set = row[static_cast<std::size_t>(x)] == pixel;
      if (set ? inside < -0.01 : inside > 0.01) return false;
    }
  }
  return true;
}

template <class Pixel>
void fill(benchmark::State& state) {
  Page<Pixel> page(side, side);
  xsharp::Filler filler;
  const auto points = disk(static_cast<double>(state.range(0)));
  const std::int64_t pixels = filler.fill(page, std::span<const ScreenPoint>(points), Pixel{7});
  if (!is_filled(page, points, Pixel{7}) ||
      pixels != std::count(page.pixels().begin(), page.pixels().end(), Pixel{7})) {
    state.SkipWithError("wrong pixels");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    filler.fill(page, std::span<const ScreenPoint>(points), Pixel{7});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * pixels);
  state.counters["pixels"] = static_cast<double>(pixels);
}

/// As many pixels as fill() of the same size sets, in one piece.
template <class Pixel>
void memset_same(benchmark::State& state) {
  Page<Pixel> page(side, side);
  const auto points = disk(static_cast<double>(state.range(0)));
  const std::int64_t pixels =
      xsharp::Filler().fill(page, std::span<const ScreenPoint>(points), Pixel{7});
  for ([[maybe_unused]] auto _ : state) {
    std::memset(page.pixels().data(), 7, static_cast<std::size_t>(pixels) * sizeof(Pixel));
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * pixels);
}

/// By its corners, which go round one way or the other.
double area_of(std::span<const ScreenPoint> points) {
  std::int64_t doubled = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ScreenPoint& a = points[i];
    const ScreenPoint& b = points[(i + 1) % points.size()];
    doubled += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return std::fabs(static_cast<double>(doubled)) / 2;
}

double area_of(const Picture& picture) {
  double area = 0;
  for (const xsharp::Polygon& polygon : picture.polygons) {
    area += area_of(picture.points_of(polygon));
  }
  return area;
}

/// Whether as many pixels as the picture covers differ from that in the corner, which it does not.
template <class Pixel>
bool is_drawn(const Page<Pixel>& page, const Picture& picture) {
  const auto pixels = page.pixels();
  const auto empty = std::count(pixels.begin(), pixels.end(), pixels.front());
  const auto drawn = static_cast<double>(std::ssize(pixels) - empty);
  return std::fabs(drawn / area_of(picture) - 1) < 0.02;
}

template <class Pixel>
void frames(benchmark::State& state) {
  constexpr std::size_t count = 40;
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < count; ++i) {
    pictures.push_back(ball(2 * std::numbers::pi * static_cast<double>(i) / count));
  }
  xsharp::Screen<Pixel> screen(width, height, xsharp::PaletteKind::shading, 0);
  double area = 0;
  for (const Picture& picture : pictures) {
    screen.show(picture);
    area += area_of(picture);
    if (!is_drawn(screen.page(), picture)) {
      state.SkipWithError("wrong pixels");
      return;
    }
  }
  const std::int64_t before = screen.count().pixels;
  if (std::fabs(static_cast<double>(before) / area - 1) > 0.02) {
    state.SkipWithError("wrong count of pixels");
    return;
  }
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    screen.show(pictures[next]);
    benchmark::ClobberMemory();
    next = (next + 1) % count;
  }
  const std::int64_t pixels = screen.count().pixels - before;
  state.SetItemsProcessed(pixels);
  state.counters["frames"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["page"] =
      static_cast<double>(pixels) / (static_cast<double>(state.iterations()) * width * height);
}

void radii(benchmark::internal::Benchmark* bench) {
  for (const std::int64_t radius : {3, 10, 30, 100, 300, 1000}) bench->Arg(radius);
}

BENCHMARK(fill<std::uint8_t>)->Apply(radii);
BENCHMARK(memset_same<std::uint8_t>)->Apply(radii);
BENCHMARK(fill<std::uint32_t>)->Apply(radii);
BENCHMARK(memset_same<std::uint32_t>)->Apply(radii);
BENCHMARK(frames<std::uint8_t>);
BENCHMARK(frames<std::uint32_t>);

}  // namespace
