// Times highlights and unit vectors, and counts what they get wrong.
//
// Highlight/*: the highlights of the faces that xsharp/scenes/highlight.json shows, with correctly
// rounded powers, with repeated products, and in float. Each variant takes the same 16.16 normals,
// places and lights, and adds its highlight to the same colour. `faces` and `pixels` count what 60
// frames show. `wrong` counts the pixels whose colour is not that of double, and `most` is the
// largest difference in 255ths.
//
// Unit/*: unit vectors of 16.16 vectors, by the length and divides, by a reciprocal root and
// products, and in float. `ulp` is the largest error of a component, and `rounded` is the share of
// components that are the nearest.
//
// Frame/*: a frame of that scene before it is filled, with highlights and without.
//
// A scene that cannot be read, or is not drawn without errors, is an error of its benchmarks.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "fixed/fixed.hpp"
#include "xsharp/animation.hpp"
#include "xsharp/files/scene_json.hpp"
#include "xsharp/raster/fill.hpp"
#include "xsharp/raster/page.hpp"

namespace {

using Type = fixproof::q16_16_i386;

/// The type, with powers by repeated products.
struct Repeated {
  Type n{};

  friend Repeated operator+(Repeated a, Repeated b) { return {a.n + b.n}; }
  friend Repeated operator-(Repeated a, Repeated b) { return {a.n - b.n}; }
  Repeated operator-() const { return {-n}; }
  friend Repeated operator*(Repeated a, Repeated b) { return {a.n * b.n}; }
  friend bool operator==(Repeated, Repeated) = default;
  friend auto operator<=>(Repeated, Repeated) = default;
  explicit operator double() const { return static_cast<double>(n); }
};

}  // namespace

namespace xsharp {

template <>
struct Arithmetic<Repeated> {
  using N = Repeated;
  using Of = Arithmetic<Type>;
  static constexpr bool divides_by_whole_part() { return false; }

  static std::int32_t raw(N x) { return x.n.raw(); }
  static N from_raw(std::int32_t raw) { return {Type::from_raw(raw)}; }
  static N constant(double value, Conversion conversion) {
    return {Of::constant(value, conversion)};
  }
  static std::optional<N> divide(N n, N d) {
    const auto quotient = Of::divide(n.n, d.n);
    return quotient ? std::optional(N{*quotient}) : std::nullopt;
  }
  static N length(const Vec3<N>& v) { return {Of::length({v.x.n, v.y.n, v.z.n})}; }
  /// Squares, and products of them for the bits of a whole exponent.
  static N power(N base, N exponent) {
    N result = from_raw(65536);
    for (std::int32_t bits = raw(exponent) / 65536; bits > 0; bits /= 2) {
      if (bits % 2 != 0) result = result * base;
      base = base * base;
    }
    return result;
  }
};

}  // namespace xsharp

namespace {

using namespace xsharp;

constexpr int frames = 60;
constexpr int frames_between = 10;

const Scene& glossy() {
  static const Scene scene = read_scene(SCENES "/highlight.json");
  return scene;
}

Scene dull() {
  Scene scene = glossy();
  for (ObjectDescription& object : scene.objects) {
    for (Shading& shading : object.shadings) shading.highlight.reset();
  }
  return scene;
}

template <class N>
N number(std::int32_t raw) {
  return Arithmetic<N>::from_raw(raw);
}

using Words = std::array<std::int32_t, 3>;

template <class N>
Vec3<N> vector(const Words& words) {
  return {number<N>(words[0]), number<N>(words[1]), number<N>(words[2])};
}

/// A visible face in 16.16 words, and the number of its pixels that nothing covers.
struct Seen {
  Words normal{};
  Words to_viewer{};
  Highlight highlight{};
  Color without{};
  std::int64_t pixels = 0;
};

/// The middle between a and b, rounded toward a, as in Arithmetic::midpoint().
Words between(const Words& a, const Words& b) {
  return {std::midpoint(a[0], b[0]), std::midpoint(a[1], b[1]), std::midpoint(a[2], b[2])};
}

void add_frame(std::vector<Seen>& all, const Scene& scene, const Player& player,
               const Picture& picture) {
  // A pixel of the page has the number of its polygon, from 1.
  Page<std::uint32_t> page(scene.width, scene.height);
  Filler filler;
  std::vector<std::size_t> drawn(scene.objects.size());
  const std::size_t first = all.size();
  for (const Polygon& polygon : picture.polygons) {
    const ObjectDescription& object = scene.objects[polygon.object];
    const ObjectState state = player.state(polygon.object);
    const std::size_t index = state.visible.at(drawn[polygon.object]++);
    const Face& face = object.mesh.faces[index];
    const Words& start = state.view[face.vertices[0]];
    const Words& end = state.view[*face.normal_end];
    const Words middle = between(start, state.view[face.vertices[face.vertices.size() / 2]]);
    const auto to_viewer = unit_vector(vector<Type>({-middle[0], -middle[1], -middle[2]}));
    all.push_back({{end[0] - start[0], end[1] - start[1], end[2] - start[2]},
                   {to_viewer.x.raw(), to_viewer.y.raw(), to_viewer.z.raw()},
                   *glossy().objects[polygon.object].shadings[index].highlight,
                   polygon.paint.color});
    filler.fill<std::uint32_t>(page, picture.points_of(polygon),
                               static_cast<std::uint32_t>(all.size() - first));
  }
  for (const std::uint32_t pixel : page.pixels()) {
    if (pixel != 0) ++all[first + pixel - 1].pixels;
  }
}

/// @throws std::runtime_error if something was not drawn
void require_all_drawn(const Tally& tally) {
  if (tally.faults == 0 && tally.out_of_reach == 0) return;
  throw std::runtime_error("xsharp/scenes/highlight.json has " + std::to_string(tally.faults) +
                           " divide errors and " + std::to_string(tally.out_of_reach) +
                           " objects out of reach");
}

/// A benchmark whose exceptions are its errors.
template <void (*Benchmark)(benchmark::State&)>
void reported(benchmark::State& state) {
  try {
    Benchmark(state);
  } catch (const std::exception& error) {
    state.SkipWithError(error.what());
  }
}

/// The visible faces of the frames.
const std::vector<Seen>& faces() {
  static const std::vector<Seen> all = [] {
    std::vector<Seen> seen;
    const Scene scene = dull();
    Animation<Type> animation(scene);
    Picture picture;
    for (int frame = 0; frame < frames * frames_between; ++frame) {
      if (frame > 0) animation.move();
      if (frame % frames_between != 0) continue;
      require_all_drawn(animation.draw(picture));
      add_frame(seen, scene, animation, picture);
    }
    return seen;
  }();
  return all;
}

/// The scene's lights, from the same words for every number type.
template <class N>
Lighting<N> lighting() {
  const auto view = view_of<Type>(glossy());
  const auto of = lighting_of<Type>(glossy().lights, glossy().conversion, view.world_to_view);
  Lighting<N> result;
  for (const Ray<Type>& ray : of.rays) {
    const auto same = [](Type x) { return number<N>(x.raw()); };
    result.rays.push_back({ray.on,
                           {same(ray.to_light.x), same(ray.to_light.y), same(ray.to_light.z)},
                           {same(ray.intensity[0]), same(ray.intensity[1]), same(ray.intensity[2])},
                           {}});
  }
  return result;
}

template <class N>
std::vector<Color> colors() {
  const Lighting<N> lights = lighting<N>();
  std::vector<Color> all;
  for (const Seen& face : faces()) {
    all.push_back(with_highlight(face.without, vector<N>(face.normal), vector<N>(face.to_viewer),
                                 face.highlight, lights));
  }
  return all;
}

template <class N>
void highlight(benchmark::State& state) {
  static const std::vector<Color> exact = colors<double>();
  const std::vector<Color> is = colors<N>();
  std::int64_t pixels = 0;
  std::int64_t wrong = 0;
  int most = 0;
  for (std::size_t i = 0; i < is.size(); ++i) {
    const int off =
        std::max({std::abs(is[i].red - exact[i].red), std::abs(is[i].green - exact[i].green),
                  std::abs(is[i].blue - exact[i].blue)});
    pixels += faces()[i].pixels;
    wrong += off == 0 ? 0 : faces()[i].pixels;
    most = std::max(most, off);
  }
  const Lighting<N> lights = lighting<N>();
  std::vector<std::array<Vec3<N>, 2>> vectors;
  for (const Seen& face : faces()) {
    vectors.push_back({vector<N>(face.normal), vector<N>(face.to_viewer)});
  }
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < vectors.size(); ++i) {
      const Seen& face = faces()[i];
      benchmark::DoNotOptimize(
          with_highlight(face.without, vectors[i][0], vectors[i][1], face.highlight, lights));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(vectors.size()));
  state.counters["faces"] = static_cast<double>(vectors.size());
  state.counters["wrong"] = static_cast<double>(wrong);
  state.counters["pixels"] = static_cast<double>(pixels);
  state.counters["most"] = most;
}
BENCHMARK(reported<highlight<Type>>)->Name("Highlight/pow");
BENCHMARK(reported<highlight<Repeated>>)->Name("Highlight/products");
BENCHMARK(reported<highlight<float>>)->Name("Highlight/float");
BENCHMARK(reported<highlight<double>>)->Name("Highlight/double");

/// A unit vector by the reciprocal of the root of the vector's square. The vector is first scaled
/// until its longest component is from 1 to 2, so that the square neither overflows nor loses bits.
Vec3<Type> by_reciprocal_root(Vec3<Type> v) {
  const auto size = [](Type x) { return x.raw() < 0 ? -std::int64_t{x.raw()} : x.raw(); };
  std::int64_t longest = std::max({size(v.x), size(v.y), size(v.z)});
  if (longest == 0) return v;
  for (; longest < 65536; longest *= 2) v = v + v;
  for (; longest >= 2 * 65536; longest /= 2) {
    const auto half = [](Type x) { return Type::from_raw(x.raw() / 2); };
    v = {half(v.x), half(v.y), half(v.z)};
  }
  return v * fixproof::rsqrt(dot(v, v));
}

Vec3<float> in_float(const Vec3<float>& v) {
  const float size = std::sqrt(dot(v, v));
  return {v.x / size, v.y / size, v.z / size};
}

/// Vectors of all lengths from 1/4 to 16384.
const std::vector<Words>& directions() {
  static const std::vector<Words> all = [] {
    std::vector<Words> words(4096);
    std::mt19937 random(1994);
    for (std::size_t i = 0; i < words.size(); ++i) {
      for (std::int32_t& word : words[i]) {
        word = static_cast<std::int32_t>(random()) >> (1 + i % 16);
      }
    }
    return words;
  }();
  return all;
}

template <class N, class Unit>
void unit(benchmark::State& state, const Unit& unit_of) {
  double most = 0;
  std::int64_t rounded = 0;
  std::vector<Vec3<N>> in;
  for (const Words& words : directions()) {
    in.push_back(vector<N>(words));
    const Vec3<N> is = unit_of(in.back());
    const std::array parts{static_cast<double>(is.x), static_cast<double>(is.y),
                           static_cast<double>(is.z)};
    const std::array<long double, 3> of{static_cast<long double>(words[0]),
                                        static_cast<long double>(words[1]),
                                        static_cast<long double>(words[2])};
    const long double size = std::sqrt(of[0] * of[0] + of[1] * of[1] + of[2] * of[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto exact = static_cast<double>(of[i] / size * 65536);
      const double units = parts[i] * 65536;
      most = std::max(most, std::fabs(units - exact));
      rounded += std::floor(units + 0.5) == std::floor(exact + 0.5) ? 1 : 0;
    }
  }
  if (most > 8) {
    state.SkipWithError("no unit vector");
    return;
  }
  std::vector<Vec3<N>> out(in.size());
  for ([[maybe_unused]] auto _ : state) {
    std::ranges::transform(in, out.begin(), unit_of);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(in.size()));
  state.counters["ulp"] = most;
  state.counters["rounded"] = static_cast<double>(rounded) / static_cast<double>(3 * in.size());
}
void unit_by_length(benchmark::State& state) { unit<Type>(state, unit_vector<Type>); }
void unit_by_root(benchmark::State& state) { unit<Type>(state, by_reciprocal_root); }
void unit_in_float(benchmark::State& state) { unit<float>(state, in_float); }
BENCHMARK(reported<unit_by_length>)->Name("Unit/hypot");
BENCHMARK(reported<unit_by_root>)->Name("Unit/rsqrt");
BENCHMARK(reported<unit_in_float>)->Name("Unit/float");

template <class N>
void frame(benchmark::State& state, const Scene& scene) {
  Animation<N> animation(scene);
  Picture picture;
  Tally tally;
  for ([[maybe_unused]] auto _ : state) {
    animation.move();
    tally = tally + animation.draw(picture);
    benchmark::DoNotOptimize(picture.points.data());
  }
  require_all_drawn(tally);
}
void frame_with(benchmark::State& state) { frame<Type>(state, glossy()); }
void frame_without(benchmark::State& state) { frame<Type>(state, dull()); }
void frame_float_with(benchmark::State& state) { frame<float>(state, glossy()); }
void frame_float_without(benchmark::State& state) { frame<float>(state, dull()); }
BENCHMARK(reported<frame_with>)->Name("Frame/highlights");
BENCHMARK(reported<frame_without>)->Name("Frame/none");
BENCHMARK(reported<frame_float_with>)->Name("Frame/float/highlights");
BENCHMARK(reported<frame_float_without>)->Name("Frame/float/none");

}  // namespace
