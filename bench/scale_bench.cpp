// Scenes of 10 to 100,000 balls, each of 114 vertices and 128 faces: what a frame costs before it
// is filled, on one thread and on two, and what the objects take in memory; sorting alone; copying,
// for the bandwidth of the memory. The pictures are checked: the type draws as many polygons as
// double, within a hundredth, and the same ones on any number of threads.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "fixed/fixed.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/depth.hpp"
#include "xsharp/shapes.hpp"

namespace {

using Type = fixed::q16_16_i386;

constexpr std::int64_t vertices = 114;

/// Balls in a cloud, each turning in its own way, all in sight.
xsharp::Scene cloud(std::int64_t balls) {
  xsharp::Scene scene;
  std::mt19937 random(1994);
  const auto from_to = [&random](double from, double to) {
    return from + (to - from) * (random() / 4294967296.0);
  };
  const xsharp::Mesh body = xsharp::ball(10, 8);
  for (std::int64_t i = 0; i < balls; ++i) {
    xsharp::ObjectDescription object;
    object.mesh = body;
    object.paints.assign(body.faces.size(), xsharp::Paint{.index = 15});
    object.position = {from_to(-400, 400), from_to(-300, 300), from_to(-3000, -1000)};
    object.spin.tenths = {static_cast<std::int32_t>(10 + i % 20), 20, 0};
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

std::size_t polygons_of_a_frame(xsharp::Player& player) {
  xsharp::Picture picture;
  player.move();
  player.draw(picture);
  return picture.polygons.size();
}

/// As far as pictures can be told apart by what they cover.
bool is_right(const xsharp::Scene& scene, std::size_t threads) {
  xsharp::Animation<Type> one(scene);
  xsharp::Animation<Type> shared(scene, threads);
  xsharp::Animation<double> exact(scene);
  const auto drawn = static_cast<double>(polygons_of_a_frame(one));
  return drawn == static_cast<double>(polygons_of_a_frame(shared)) &&
         std::fabs(drawn / static_cast<double>(polygons_of_a_frame(exact)) - 1) < 0.01;
}

template <class N>
void frame(benchmark::State& state) {
  const auto threads = static_cast<std::size_t>(state.range(1));
  const xsharp::Scene scene = cloud(state.range(0));
  // The large ones are the small ones over again.
  if (state.range(0) <= 1000 && !is_right(scene, threads)) {
    state.SkipWithError("the pictures are wrong");
  }
  const std::size_t before = mallinfo2().uordblks + mallinfo2().hblkhd;
  xsharp::Animation<N> animation(scene, threads);
  xsharp::Picture picture;
  animation.draw(picture);
  const std::size_t after = mallinfo2().uordblks + mallinfo2().hblkhd;
  for (auto _ : state) {
    animation.move();
    animation.draw(picture);
    benchmark::DoNotOptimize(picture.points.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0) * vertices);
  state.counters["bytes_per_vertex"] =
      static_cast<double>(after - before) / static_cast<double>(state.range(0) * vertices);
}

/// Depths of objects that move a little: about every tenth changes places with a neighbour.
void sort_little(benchmark::State& state) {
  const auto objects = static_cast<std::size_t>(state.range(0));
  std::mt19937 random(1994);
  std::vector<std::int32_t> depths(objects);
  std::iota(depths.begin(), depths.end(), 0);
  std::vector<std::size_t> order(objects);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (auto _ : state) {
    state.PauseTiming();
    for (std::size_t i = 0; i + 1 < objects; i += 10) {
      std::swap(depths[(i + random() % 9) % objects], depths[i]);
    }
    state.ResumeTiming();
    xsharp::sort_by_depth(order, std::span<const std::int32_t>(depths));
    benchmark::DoNotOptimize(order.data());
  }
  const auto nearer = [&](std::size_t a, std::size_t b) { return depths[a] < depths[b]; };
  if (!std::is_sorted(order.begin(), order.end(), nearer)) state.SkipWithError("not sorted");
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// The worst for insertion: all turned about.
void sort_reversed(benchmark::State& state) {
  const auto objects = static_cast<std::size_t>(state.range(0));
  std::vector<std::int32_t> depths(objects);
  std::iota(depths.begin(), depths.end(), 0);
  std::vector<std::size_t> order(objects);
  for (auto _ : state) {
    state.PauseTiming();
    std::iota(order.rbegin(), order.rend(), std::size_t{0});
    state.ResumeTiming();
    xsharp::sort_by_depth(order, std::span<const std::int32_t>(depths));
    benchmark::DoNotOptimize(order.data());
  }
  if (!std::is_sorted(order.begin(), order.end())) state.SkipWithError("not sorted");
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// As many bytes as the coordinates of a frame: 12 in and 12 out for each vertex.
void copy(benchmark::State& state) {
  const std::vector<std::int32_t> from(static_cast<std::size_t>(state.range(0) * vertices * 3), 7);
  std::vector<std::int32_t> to(from.size());
  for (auto _ : state) {
    std::copy(from.begin(), from.end(), to.begin());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  if (to != from) state.SkipWithError("not copied");
  state.SetItemsProcessed(state.iterations() * state.range(0) * vertices);
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const std::int64_t threads : {1, 2}) {
    for (const std::int64_t objects : {10, 100, 1'000, 10'000, 100'000}) {
      bench->Args({objects, threads});
    }
  }
  bench->ArgNames({"objects", "threads"})->UseRealTime()->Unit(benchmark::kMicrosecond);
}

BENCHMARK(frame<Type>)->Apply(sizes);
BENCHMARK(frame<double>)->Apply(sizes);
BENCHMARK(sort_little)->RangeMultiplier(10)->Range(10, 1'000'000);
BENCHMARK(sort_reversed)->RangeMultiplier(10)->Range(10, 1'000'000);
BENCHMARK(copy)->RangeMultiplier(10)->Range(10, 100'000);

}  // namespace
