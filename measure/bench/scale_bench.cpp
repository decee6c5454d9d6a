// Times scenes of 10 to 100,000 balls of 114 vertices and 128 faces each: a frame before filling,
// on one thread and on two; sorting; and copying, for the memory bandwidth. Also reports the memory
// of the objects. Checks the pictures of each size once: every vertex is within a pixel of its
// position in double, and two threads give the same points and polygons as one. Uses wall clock
// time for frames and copies, because each thread has its own processor time.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "fixed/fixed.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/depth.hpp"
#include "xsharp/shapes.hpp"

namespace {

using Type = fixproof::q16_16_i386;

constexpr std::int64_t vertices = 114;

/// A cloud of balls in view, each with its own rotation. Caches the last cloud.
const xsharp::Scene& cloud(std::int64_t balls) {
  static xsharp::Scene scene;
  if (static_cast<std::int64_t>(scene.objects.size()) == balls) return scene;
  scene.objects.clear();
  std::mt19937 random(1994);
  const auto from_to = [&random](double from, double to) {
    return from + (to - from) * (static_cast<double>(random()) / 4294967296.0);
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

xsharp::Picture second_frame(xsharp::Player& player) {
  xsharp::Picture picture;
  player.draw(picture);
  player.move();
  player.draw(picture);
  return picture;
}

bool is_same(const xsharp::Polygon& a, const xsharp::Polygon& b) {
  return a.object == b.object && a.first == b.first && a.points == b.points && a.paint == b.paint;
}

bool is_near(const std::optional<xsharp::ScreenPoint>& a,
             const std::optional<xsharp::ScreenPoint>& b) {
  return a && b && std::abs(a->x - b->x) <= 1 && std::abs(a->y - b->y) <= 1;
}

bool is_near_double(const xsharp::Scene& scene, const xsharp::Player& player) {
  xsharp::Animation<double> exact(scene);
  second_frame(exact);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!std::ranges::equal(player.state(i).screen, exact.state(i).screen, is_near)) return false;
  }
  return true;
}

bool is_right(const xsharp::Scene& scene) {
  xsharp::Animation<Type> one(scene);
  const xsharp::Picture picture = second_frame(one);
  if (!is_near_double(scene, one)) return false;
  xsharp::Animation<Type> shared(scene, 2);
  const xsharp::Picture other = second_frame(shared);
  return picture.points == other.points &&
         std::ranges::equal(picture.polygons, other.polygons, is_same);
}

/// Caches the result per size for repetitions.
bool is_correct(const xsharp::Scene& scene) {
  static std::map<std::size_t, bool> known;
  const auto found = known.find(scene.objects.size());
  if (found != known.end()) return found->second;
  return known[scene.objects.size()] = is_right(scene);
}

template <class N>
void frame(benchmark::State& state) {
  const auto threads = static_cast<std::size_t>(state.range(1));
  const xsharp::Scene& scene = cloud(state.range(0));
  if (!is_correct(scene)) {
    state.SkipWithError("the pictures are wrong");
    return;
  }
  const std::size_t before = mallinfo2().uordblks + mallinfo2().hblkhd;
  xsharp::Animation<N> animation(scene, threads);
  xsharp::Picture picture;
  animation.draw(picture);
  const std::size_t after = mallinfo2().uordblks + mallinfo2().hblkhd;
  for ([[maybe_unused]] auto _ : state) {
    animation.move();
    animation.draw(picture);
    benchmark::DoNotOptimize(picture.points.data());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0) * vertices);
  state.counters["bytes_per_vertex"] =
      static_cast<double>(after - before) / static_cast<double>(state.range(0) * vertices);
}

/// Sorts depths[i] = i from a given order. Each run sorts a copy.
void sort_from(benchmark::State& state, const std::vector<std::size_t>& order) {
  std::vector<std::int32_t> depths(order.size());
  std::iota(depths.begin(), depths.end(), 0);
  std::vector<std::size_t> sorted;
  for ([[maybe_unused]] auto _ : state) {
    sorted = order;
    xsharp::sort_by_depth(sorted, std::span<const std::int32_t>(depths));
    benchmark::DoNotOptimize(sorted.data());
  }
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (sorted[i] != i) state.SkipWithError("not sorted");
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

std::vector<std::size_t> in_order(std::int64_t objects) {
  std::vector<std::size_t> order(static_cast<std::size_t>(objects));
  std::iota(order.begin(), order.end(), std::size_t{0});
  return order;
}

/// Swaps one element in ten with one at most eight places later.
void sort_little(benchmark::State& state) {
  std::mt19937 random(1994);
  std::vector<std::size_t> order = in_order(state.range(0));
  for (std::size_t i = 0; i + 8 < order.size(); i += 10) {
    std::swap(order[i], order[i + 1 + random() % 8]);
  }
  sort_from(state, order);
}

/// The reverse order is the worst case for insertion sort.
void sort_reversed(benchmark::State& state) {
  std::vector<std::size_t> order = in_order(state.range(0));
  std::reverse(order.begin(), order.end());
  sort_from(state, order);
}

/// Copies as many bytes as the coordinates of a frame: 12 in and 12 out per vertex.
void copy(benchmark::State& state) {
  const std::vector<std::int32_t> from(static_cast<std::size_t>(state.range(0) * vertices * 3), 7);
  std::vector<std::int32_t> to(from.size());
  for ([[maybe_unused]] auto _ : state) {
    std::copy(from.begin(), from.end(), to.begin());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  if (to != from) state.SkipWithError("not copied");
  state.SetItemsProcessed(state.iterations() * state.range(0) * vertices);
}

void sizes(benchmark::internal::Benchmark* bench) {
  for (const std::int64_t objects : {10, 100, 1'000, 10'000, 100'000}) {
    for (const std::int64_t threads : {1, 2}) bench->Args({objects, threads});
  }
  bench->ArgNames({"objects", "threads"})->UseRealTime()->Unit(benchmark::kMicrosecond);
}

BENCHMARK(frame<Type>)->Apply(sizes);
BENCHMARK(frame<double>)->Apply(sizes);
BENCHMARK(sort_little)->RangeMultiplier(10)->Range(10, 1'000'000);
BENCHMARK(sort_reversed)->RangeMultiplier(10)->Range(10, 1'000'000);
BENCHMARK(copy)->RangeMultiplier(10)->Range(10, 100'000)->UseRealTime();

}  // namespace
