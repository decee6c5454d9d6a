// Clocks per frame, counted from the calls of the model.
#include <algorithm>
#include <optional>
#include <utility>

#include "measure/clocks/frame_clocks.hpp"
#include "player/canvas.hpp"
#include "player/model_number.hpp"
#include "player/players.hpp"
#include "trade/advice/cost.hpp"
#include "xsharp/motion.hpp"
#include "xsharp/rotation.hpp"

namespace fixproof::trade {

namespace {

/// The FIXED.ASM calls that would compute orientations from angles.
class FromAngles {
 public:
  explicit FromAngles(const xsharp::Scene& scene) {
    for (xsharp::ObjectDescription object : scene.objects) {
      // Then advance() reports rotations alone.
      object.drift.reset();
      object.orbit.reset();
      objects_.push_back({object.spin.tenths, xsharp::Motion<double>(object, {})});
    }
  }

  void advance(bool counts) {
    for (Turned& object : objects_) {
      if (!object.motion.advance()) continue;
      ++object.rotations;
      if (counts) make_matrix(object);
    }
  }

 private:
  struct Turned {
    std::array<std::int32_t, 3> tenths{};
    xsharp::Motion<double> motion;
    std::int64_t rotations = 0;
  };

  /// Operands differ between builds by a few units only, so one build represents all.
  static void make_matrix(const Turned& object) {
    using N = player::ModelNumber<cases::Build{}>;
    auto matrix = xsharp::identity<N>();
    for (const xsharp::Axis axis : {xsharp::Axis::x, xsharp::Axis::y, xsharp::Axis::z}) {
      const std::int32_t step = object.tenths.at(static_cast<std::size_t>(axis));
      if (step == 0) continue;
      const auto angle = static_cast<std::int32_t>(step * object.rotations % 3600);
      xsharp::append_rotation(matrix, axis, xsharp::Arithmetic<N>::turn(angle));
    }
  }

  std::vector<Turned> objects_;
};

Cost cost_of(const measure::Clocks& c, x86model::Cpu cpu) {
  const auto [least, most] = c.at_least();
  Cost cost{least, most, (least + most) / 2};
  if (cpu == x86model::Cpu::i8088) cost.bus = c.bus;
  return cost;
}

/// The mean clocks of the sampled frames, without sharing restorations out.
measure::Clocks sampled_clocks(const xsharp::Scene& scene, x86model::Cpu cpu) {
  const auto player = player::make_player(scene, scene.arithmetic);
  const auto canvas = player::canvas_of_surfaces(scene);
  std::optional<FromAngles> angles;
  if (scene.from_scratch) angles.emplace(scene);
  const cases::Build build = player::build_of(scene.arithmetic).value();
  xsharp::Picture picture;
  measure::FrameClocks sum;
  for (std::uint64_t place = 0; place < ClockSample::places; ++place) {
    // This draw does the one-time work, so the sample contains only the work of motion.
    player->draw(picture);
    for (std::uint64_t i = 0; i < ClockSample::apart; ++i) {
      const bool counts = i < ClockSample::consecutive;
      player::OperandLog log;
      {
        std::optional<player::Recording> recording;
        if (counts) recording.emplace(log);
        player->move();
        if (angles) angles->advance(counts);
        if (counts) player->draw(picture);
        if (counts && canvas) canvas->show(picture);
      }
      if (counts) sum += measure::clocks_of(log, build, cpu);
    }
  }
  constexpr double frames = ClockSample::places * ClockSample::consecutive;
  return sum.per_frame(frames);
}

/// Interpolates between never restoring and restoring after every rotation.
measure::Clocks shared_out(const measure::Clocks& never, const measure::Clocks& always,
                           double rotations) {
  const auto mean = [rotations](double a, double b) { return a + (b - a) / rotations; };
  return {{mean(never.table.min, always.table.min), mean(never.table.max, always.table.max)},
          mean(never.bus, always.bus)};
}

class ClockMemory {
 public:
  ClockMemory(const xsharp::Scene& scene, x86model::Cpu cpu) : scene_(scene), cpu_(cpu) {}

  Cost of(Choice choice) {
    const std::int32_t every = choice.turning.restore_every;
    if (every <= 1) return cost_of(counted(choice), cpu_);
    choice.turning.restore_every = 0;
    const measure::Clocks never = counted(choice);
    choice.turning.restore_every = 1;
    return cost_of(shared_out(never, counted(choice), every), cpu_);
  }

 private:
  measure::Clocks counted(const Choice& choice) {
    for (const auto& [known, clocks] : counted_) {
      if (known == choice) return clocks;
    }
    counted_.emplace_back(choice, sampled_clocks(scene_with(scene_, choice, "model"), cpu_));
    return counted_.back().second;
  }

  const xsharp::Scene& scene_;
  x86model::Cpu cpu_;
  std::vector<std::pair<Choice, measure::Clocks>> counted_;
};

}  // namespace

std::vector<Cost> clocks_per_frame(const xsharp::Scene& scene, std::span<const Choice> choices,
                                   x86model::Cpu cpu, const std::atomic<bool>& stop,
                                   const std::function<void(std::uint64_t)>& counted) {
  ClockMemory memory(scene, cpu);
  std::vector<Cost> costs;
  for (const Choice& choice : choices) {
    if (stop) break;
    costs.push_back(memory.of(choice));
    counted(costs.size());
  }
  return costs;
}

}  // namespace fixproof::trade
