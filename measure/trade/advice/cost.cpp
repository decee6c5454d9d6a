#include "measure/trade/advice/cost.hpp"

#include <array>
#include <chrono>

#include "measure/clocks/frame_clocks.hpp"
#include "measure/host/host_times.hpp"
#include "measure/player/canvas.hpp"
#include "measure/player/model_number.hpp"
#include "measure/player/players.hpp"
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
    using N = player::ModelNumber;
    const player::InBuild build(cases::Build{});
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

/// Nanoseconds of processor time per frame.
double time_a_frame(const xsharp::Scene& scene, xsharp::Picture& picture) {
  const auto player = player::make_player(scene, scene.arithmetic);
  const auto canvas = player::canvas_of_surfaces(scene);
  // This draw does the one-time work, so the loop times only the work of motion.
  player->draw(picture);
  const auto begin = measure::thread_time();
  for (std::uint64_t frame = 0; frame < TimeSample::frames; ++frame) {
    player->move();
    player->draw(picture);
    if (canvas) canvas->show(picture);
  }
  const std::chrono::duration<double, std::nano> passed = measure::thread_time() - begin;
  return passed.count() / static_cast<double>(TimeSample::frames);
}

}  // namespace

std::vector<Cost> clocks_per_frame(const xsharp::Scene& scene, std::span<const Choice> choices,
                                   x86model::Cpu cpu, const std::atomic<bool>& stop,
                                   const std::function<void(std::uint64_t)>& counted) {
  const std::vector<Choice> measured = measured_choices(choices);
  std::vector<std::vector<double>> figures;
  for (const Choice& choice : measured) {
    if (stop) return {};
    const measure::Clocks clocks = sampled_clocks(scene_with(scene, choice, "model"), cpu);
    figures.push_back({clocks.table.min, clocks.table.max, clocks.bus});
    counted(figures.size() * choices.size() / measured.size());
  }
  std::vector<Cost> costs;
  for (const Choice& choice : choices) {
    const std::vector<double> of = figures_of(choice, measured, figures);
    costs.push_back(cost_of({{of[0], of[1]}, of[2]}, cpu));
  }
  return costs;
}

std::vector<Cost> nanoseconds_per_frame(const xsharp::Scene& scene, std::span<const Choice> choices,
                                        const std::atomic<bool>& stop) {
  const std::vector<Choice> measured = measured_choices(choices);
  std::vector<std::vector<double>> samples(measured.size());
  xsharp::Picture picture;
  // Times the choices in turn, so that a slow phase of the machine affects all of them.
  for (std::uint64_t round = 0; round < TimeSample::rounds; ++round) {
    for (std::size_t i = 0; i < measured.size(); ++i) {
      if (stop) return {};
      samples[i].push_back(time_a_frame(scene_with(scene, measured[i], "type"), picture));
    }
  }
  std::vector<Cost> costs;
  for (const Choice& choice : choices) {
    const measure::Times times = measure::times_of(figures_of(choice, measured, samples));
    costs.push_back({times.min, times.median, times.median, times.spread * times.median});
  }
  return costs;
}

}  // namespace fixproof::trade
