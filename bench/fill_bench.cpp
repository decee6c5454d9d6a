// Filling polygons of few and of many pixels beside memset of as many, and whole frames of a ball
// with 36 faces, over a fifth to a quarter of a page of 320 x 240, with what is erased before them.
// What is drawn is checked first; memset needs no check.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
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

template <class Pixel>
void fill(benchmark::State& state) {
  Page<Pixel> page(side, side);
  xsharp::Filler filler;
  const auto points = disk(static_cast<double>(state.range(0)));
  const std::int64_t pixels = filler.fill(page, std::span<const ScreenPoint>(points), Pixel{7});
  if (pixels != std::count(page.pixels().begin(), page.pixels().end(), Pixel{7})) {
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

template <class Pixel>
void frames(benchmark::State& state) {
  constexpr std::size_t count = 40;
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < count; ++i) {
    pictures.push_back(ball(2 * std::numbers::pi * static_cast<double>(i) / count));
  }
  xsharp::Screen<Pixel> screen(width, height, xsharp::PaletteKind::shading, 0);
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    screen.show(pictures[next]);
    benchmark::ClobberMemory();
    next = (next + 1) % count;
  }
  const auto& drawn = screen.count();
  if (drawn.polygons != state.iterations() * 36) {
    state.SkipWithError("wrong polygons");
    return;
  }
  state.SetItemsProcessed(drawn.pixels);
  state.counters["frames"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["page"] = static_cast<double>(drawn.pixels) /
                           (static_cast<double>(state.iterations()) * width * height);
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
