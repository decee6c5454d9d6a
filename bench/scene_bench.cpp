// Vertices transformed, and whole frames of the scenes that come with the project, on the type, in
// double and on the model. What is timed is checked: vertices against the products written out in
// 64-bit integers, frames by their count of pixels, which fixed point and double agree upon within
// a hundredth.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "verify/scenes/players.hpp"
#include "xsharp/arithmetic.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/raster/screen.hpp"
#include "xsharp/rotation.hpp"

namespace {

using xsharp::Arithmetic;
using xsharp::Transform;
using xsharp::Vec3;

/// As 16.16 is written by hand: 64-bit products, rounded halves up.
std::int32_t by_hand(const std::int32_t* row, const std::int32_t* v) {
  std::uint32_t sum = static_cast<std::uint32_t>(row[3]);
  for (int i = 0; i < 3; ++i) {
    sum += static_cast<std::uint32_t>((std::int64_t{row[i]} * v[i] + 0x8000) >> 16);
  }
  return static_cast<std::int32_t>(sum);
}

template <class N>
Transform<N> some_transform() {
  auto t = xsharp::identity<N>();
  xsharp::append_rotation(t, xsharp::Axis::x, Arithmetic<N>::turn(123));
  xsharp::append_rotation(t, xsharp::Axis::y, Arithmetic<N>::turn(456));
  t.rows[2][3] = Arithmetic<N>::from_raw(-20'000'000);
  return t;
}

template <class N>
std::vector<Vec3<N>> some_vertices(std::size_t count) {
  std::vector<Vec3<N>> vertices;
  std::uint32_t bits = 1994;
  const auto next = [&bits] {
    bits = bits * 1664525U + 1013904223U;
    return Arithmetic<N>::from_raw(static_cast<std::int32_t>(bits) / 128);
  };
  for (std::size_t i = 0; i < count; ++i) vertices.push_back({next(), next(), next()});
  return vertices;
}

template <class N>
void transform(benchmark::State& state) {
  const auto t = some_transform<N>();
  const auto vertices = some_vertices<N>(4096);
  std::vector<Vec3<N>> view(vertices.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      view[i] = Arithmetic<N>::apply(t, vertices[i]);
    }
    benchmark::DoNotOptimize(view.data());
    benchmark::ClobberMemory();
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    std::int32_t row[4];
    for (std::size_t j = 0; j < 4; ++j) row[j] = Arithmetic<N>::raw(t.rows[2][j]);
    const Vec3<N>& v = vertices[i];
    const std::int32_t in[3] = {Arithmetic<N>::raw(v.x), Arithmetic<N>::raw(v.y),
                                Arithmetic<N>::raw(v.z)};
    // Unrounded sines and cosines are half a unit off at most, times coordinates within 256.
    constexpr std::int32_t tolerance = std::is_same_v<N, double> ? 3 * 128 + 3 : 3;
    if (std::abs(by_hand(row, in) - Arithmetic<N>::raw(view[i].z)) > tolerance) {
      state.SkipWithError("a vertex is wrong");
      return;
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(vertices.size()));
}

void transform_by_hand(benchmark::State& state) {
  const auto t = some_transform<fixed::q16_16>();
  std::int32_t rows[3][4];
  for (std::size_t i = 0; i < 12; ++i) rows[i / 4][i % 4] = t.rows[i / 4][i % 4].raw();
  const auto vertices = some_vertices<fixed::q16_16>(4096);
  std::vector<std::int32_t> in;
  for (const auto& v : vertices) in.insert(in.end(), {v.x.raw(), v.y.raw(), v.z.raw()});
  std::vector<std::int32_t> view(in.size());
  for (auto _ : state) {
    for (std::size_t i = 0; i < in.size(); i += 3) {
      for (std::size_t j = 0; j < 3; ++j) view[i + j] = by_hand(rows[j], &in[i]);
    }
    benchmark::DoNotOptimize(view.data());
    benchmark::ClobberMemory();
  }
  const auto last = Arithmetic<fixed::q16_16>::apply(t, vertices.back());
  if (view.back() != last.z.raw()) state.SkipWithError("a vertex is wrong");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(vertices.size()));
}

std::int64_t pixels_of_frames(const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice) {
  const auto player = fixproof::make_player(scene, choice);
  xsharp::Screen<std::uint8_t> screen(scene.width, scene.height, scene.palette, scene.background);
  xsharp::Picture picture;
  for (int i = 0; i < 100; ++i) {
    player->draw(picture);
    screen.show(picture);
    player->move();
  }
  return screen.count().pixels;
}

void frames(benchmark::State& state, const std::string& name,
            const xsharp::ArithmeticChoice& choice) {
  const xsharp::Scene scene = xsharp::read_scene(std::string(SCENES) + "/" + name + ".json");
  const auto exact = static_cast<double>(pixels_of_frames(scene, {"double", "", true, true}));
  const auto drawn = static_cast<double>(pixels_of_frames(scene, choice));
  if (std::fabs(drawn / exact - 1) > 0.01) state.SkipWithError("the pictures are wrong");
  const auto player = fixproof::make_player(scene, choice);
  xsharp::Screen<std::uint8_t> screen(scene.width, scene.height, scene.palette, scene.background);
  xsharp::Picture picture;
  for (auto _ : state) {
    player->move();
    player->draw(picture);
    screen.show(picture);
    benchmark::DoNotOptimize(screen.page().pixels().data());
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK(transform_by_hand);
BENCHMARK(transform<fixed::q16_16>);
BENCHMARK(transform<fixed::q16_16_i386>);
BENCHMARK(transform<fixed::q16_16_i386_unrounded>);
BENCHMARK(transform<fixed::q16_16_i8088>);
BENCHMARK(transform<fixed::q16_16_saturating>);
BENCHMARK(transform<double>);

#define FRAMES(scene)                                                                   \
  BENCHMARK_CAPTURE(frames, scene##_type_i386, #scene, {"type", "i386", true, true});   \
  BENCHMARK_CAPTURE(frames, scene##_type_i8088, #scene, {"type", "i8088", true, true}); \
  BENCHMARK_CAPTURE(frames, scene##_double, #scene, {"double", "", true, true});        \
  BENCHMARK_CAPTURE(frames, scene##_model_i386, #scene, {"model", "i386", true, true}); \
  BENCHMARK_CAPTURE(frames, scene##_model_i8088, #scene, {"model", "i8088", true, true})
FRAMES(twelve_cubes);
FRAMES(ball_and_cubes);
FRAMES(shaded_ball);

}  // namespace
