// Nanoseconds a frame, on this processor.
#include <algorithm>
#include <chrono>
#include <memory>

#include "verify/advise/cost.hpp"
#include "verify/scenes/players.hpp"

namespace fixproof {

namespace {

constexpr int timed_rounds = 7;
constexpr int timed_frames = 600;  // in a round: restored every 600 restores once

double time_a_round(xsharp::Player& player, xsharp::Picture& picture) {
  const auto begin = std::chrono::steady_clock::now();
  for (int frame = 0; frame < timed_frames; ++frame) {
    player.move();
    player.draw(picture);
  }
  const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - begin;
  return passed.count() / timed_frames;
}

}  // namespace

std::vector<Cost> nanoseconds_a_frame(const xsharp::Scene& scene, std::span<const Choice> choices,
                                      const std::atomic<bool>& stop) {
  std::vector<std::unique_ptr<xsharp::Player>> players;
  for (const Choice& choice : choices) {
    const xsharp::Scene chosen = scene_with(scene, choice, "type");
    players.push_back(make_player(chosen, chosen.arithmetic));
  }
  // In turn, so that what slows the machine for a while slows all alike.
  std::vector<std::vector<double>> times(players.size());
  xsharp::Picture picture;
  for (int round = 0; round < timed_rounds; ++round) {
    for (std::size_t i = 0; i < players.size(); ++i) {
      if (stop) return {};
      times[i].push_back(time_a_round(*players[i], picture));
    }
  }
  std::vector<Cost> costs;
  for (std::vector<double>& of_choice : times) {
    std::ranges::sort(of_choice);
    costs.push_back({of_choice.front(), of_choice[of_choice.size() / 2], of_choice.front()});
  }
  return costs;
}

}  // namespace fixproof
