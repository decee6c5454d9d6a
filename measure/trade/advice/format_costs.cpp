#include <array>
#include <memory>
#include <vector>

#include "fixed/batch/batch.hpp"
#include "measure/trade/advice/formats.hpp"
#include "xsharp/transform.hpp"

namespace fixproof::trade {

namespace {

constexpr std::uint64_t timed_rounds = 15;

/// The vertices of a scene, all behind one transform.
template <class N>
struct Vertices {
  explicit Vertices(std::size_t count) : object(count), view(count), screen(count) {
    for (std::size_t i = 0; i < count; ++i) {
      // Small enough for every format of half fraction bits; the depth is near -2.
      const auto part = static_cast<double>(i % 16) / 16;
      object[i] = {N(part - 0.5), N(0.5 - part), N(part / 2)};
    }
    to_view = xsharp::Transform<N>{};
    for (std::size_t i = 0; i < 3; ++i) to_view.rows[i][i] = N(0.75);
    to_view.rows[2][3] = N(-2);
  }

  void pass() {
    static_cast<void>(batch::transform(to_view.rows, object, view));
    static_cast<void>(batch::project(view, N(3), screen));
  }

  xsharp::Transform<N> to_view;
  std::vector<xsharp::Vec3<N>> object;
  std::vector<xsharp::Vec3<N>> view;
  std::vector<std::array<N, 2>> screen;
};

template <class N>
measure::TimedLoop loop_of(std::size_t count) {
  const auto vertices = std::make_shared<Vertices<N>>(count);
  return {[vertices] { vertices->pass(); }, 1};
}

measure::TimedLoop loop_of_width(int width, std::size_t count) {
  switch (width) {
    case 8:
      return loop_of<number<std::int8_t, 4>>(count);
    case 16:
      return loop_of<number<std::int16_t, 8>>(count);
    case 32:
      return loop_of<number<std::int32_t, 16>>(count);
    default:
      return loop_of<number<std::int64_t, 32>>(count);
  }
}

}  // namespace

std::vector<FormatCost> format_costs(const xsharp::Scene& scene, int width,
                                     const std::atomic<bool>& stop) {
  std::size_t vertices = 0;
  for (const auto& object : scene.objects) vertices += object.mesh.vertices.size();
  const std::size_t words = 6 * vertices + 24 * scene.objects.size();
  const std::array widths{32, width};
  const auto times = measure::time_in_turn(
      {loop_of_width(widths[0], vertices), loop_of_width(widths[1], vertices)}, timed_rounds, stop,
      [](std::uint64_t) {});
  std::vector<FormatCost> costs;
  for (std::size_t i = 0; i < times.size(); ++i) {
    costs.push_back({widths.at(i), words * static_cast<std::size_t>(widths.at(i)) / 8, times[i]});
  }
  return costs;
}

}  // namespace fixproof::trade
