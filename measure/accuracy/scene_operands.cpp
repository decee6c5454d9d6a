#include "measure/accuracy/scene_operands.hpp"

#include <fmt/format.h>

#include <optional>
#include <span>

#include "measure/player/players.hpp"

namespace fixproof::measure {

namespace {

const std::vector<std::uint32_t>& words_of(const player::OperandLog& log,
                                           cases::Operation operation) {
  return log.at(static_cast<std::size_t>(operation));
}

/// Appends a row of a transform and a vector whose components are `stride` words apart.
void put_dot(std::vector<std::uint32_t>& dots, std::span<const std::uint32_t> row,
             std::span<const std::uint32_t> column, std::size_t stride) {
  dots.insert(dots.end(), row.begin(), row.begin() + 3);
  for (std::size_t k = 0; k < 3; ++k) dots.push_back(column[k * stride]);
}

}  // namespace

SceneOperands record_scene(const xsharp::Scene& scene, const cases::Build& build,
                           const std::atomic<bool>& stop) {
  SceneOperands operands{.build = build};
  const auto player = player::make_player(scene, player::arithmetic_of(build, "model"));
  xsharp::Picture picture;
  for (std::uint64_t frame = 0; operands.frames < recorded_frames && !stop; ++frame) {
    try {
      std::optional<player::Recording> recording;
      const bool recorded = frame % frames_between == 0;
      if (recorded) recording.emplace(operands.log);
      if (frame > 0) player->move();
      player->draw(picture);
      if (recorded) ++operands.frames;
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}, frame {}: {}", scene.name, frame, error.what()));
    }
  }
  return operands;
}

std::vector<std::uint32_t> dots_of(const player::OperandLog& log) {
  std::vector<std::uint32_t> dots;
  const std::span<const std::uint32_t> points = words_of(log, cases::Operation::xformvec);
  constexpr std::size_t point = cases::words_in(cases::Operation::xformvec);
  for (std::size_t i = 0; i + point <= points.size(); i += point) {
    for (std::size_t row = 0; row < 3; ++row) {
      put_dot(dots, points.subspan(i + 4 * row, 3), points.subspan(i + 12, 3), 1);
    }
  }
  const std::span<const std::uint32_t> pairs = words_of(log, cases::Operation::concat);
  constexpr std::size_t pair = cases::words_in(cases::Operation::concat);
  for (std::size_t i = 0; i + pair <= pairs.size(); i += pair) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        put_dot(dots, pairs.subspan(i + 4 * row, 3), pairs.subspan(i + 12 + column), 4);
      }
    }
  }
  return dots;
}

std::vector<std::uint32_t> products_of(const player::OperandLog& log) {
  std::vector<std::uint32_t> products = words_of(log, cases::Operation::mul);
  const std::vector<std::uint32_t> dots = dots_of(log);
  for (std::size_t i = 0; i + 6 <= dots.size(); i += 6) {
    for (std::size_t k = 0; k < 3; ++k) {
      products.push_back(dots[i + k]);
      products.push_back(dots[i + 3 + k]);
    }
  }
  return products;
}

}  // namespace fixproof::measure
