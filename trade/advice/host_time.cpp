// Nanoseconds per frame on this processor.
#include <algorithm>
#include <chrono>
#include <cstddef>

#include "measure/host/host_times.hpp"
#include "player/canvas.hpp"
#include "player/players.hpp"
#include "trade/advice/cost.hpp"

namespace fixproof::trade {

namespace {

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

/// The choices to time. A restoring interval needs two of them: never and always restored.
std::vector<Choice> timed_for(std::span<const Choice> choices) {
  std::vector<Choice> timed;
  const auto add = [&timed](const Choice& choice) {
    if (std::ranges::find(timed, choice) == timed.end()) timed.push_back(choice);
  };
  for (Choice choice : choices) {
    if (choice.turning.restore_every > 1) {
      choice.turning.restore_every = 0;
      add(choice);
      choice.turning.restore_every = 1;
    }
    add(choice);
  }
  return timed;
}

class RoundTimes {
 public:
  RoundTimes(const xsharp::Scene& scene, std::vector<Choice> timed) : timed_(std::move(timed)) {
    for (const Choice& choice : timed_) scenes_.push_back(scene_with(scene, choice, "type"));
    samples_.resize(timed_.size());
  }

  /// Times the choices in turn, so that a slow phase of the machine affects all of them.
  /// @return whether the round is complete
  bool add_round(const std::atomic<bool>& stop) {
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      if (stop) return false;
      samples_[i].push_back(time_a_frame(scenes_[i], picture_));
    }
    return true;
  }

  /// Rare restorations take too little time to measure, so the cost of restoring after every
  /// rotation is shared out.
  [[nodiscard]] std::vector<double> of(Choice choice) const {
    const std::int32_t every = choice.turning.restore_every;
    if (every <= 1) return timed(choice);
    choice.turning.restore_every = 1;
    const std::vector<double>& always = timed(choice);
    choice.turning.restore_every = 0;
    std::vector<double> times = timed(choice);
    for (std::size_t round = 0; round < times.size(); ++round) {
      times[round] += (always[round] - times[round]) / every;
    }
    return times;
  }

 private:
  [[nodiscard]] const std::vector<double>& timed(const Choice& choice) const {
    const auto found = std::ranges::find(timed_, choice);
    return samples_.at(static_cast<std::size_t>(found - timed_.begin()));
  }

  std::vector<Choice> timed_;
  std::vector<xsharp::Scene> scenes_;
  std::vector<std::vector<double>> samples_;
  xsharp::Picture picture_;
};

}  // namespace

std::vector<Cost> nanoseconds_per_frame(const xsharp::Scene& scene, std::span<const Choice> choices,
                                        const std::atomic<bool>& stop) {
  RoundTimes rounds(scene, timed_for(choices));
  for (std::uint64_t round = 0; round < TimeSample::rounds; ++round) {
    if (!rounds.add_round(stop)) return {};
  }
  std::vector<Cost> costs;
  for (const Choice& choice : choices) {
    const measure::Times times = measure::times_of(rounds.of(choice));
    costs.push_back({times.min, times.median, times.median, times.spread * times.median});
  }
  return costs;
}

}  // namespace fixproof::trade
