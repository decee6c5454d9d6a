#include "measure/trade/advice/choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "measure/player/players.hpp"

namespace fixproof::trade {

namespace {

/// The intervals at 60 rotations per second: never, ten seconds, one second, shorter; from scratch.
constexpr std::array<Turning, 6> turnings{
    {{false, 0}, {false, 600}, {false, 60}, {false, 10}, {false, 1}, {true, 0}}};

}  // namespace

std::string name_of(const Turning& turning) {
  if (turning.from_scratch) return "from scratch";
  if (turning.restore_every == 0) return "never restored";
  return fmt::format("restored every {}", turning.restore_every);
}

std::vector<Choice> choices_on(std::optional<x86model::Cpu> cpu) {
  using enum x86model::Cpu;
  std::vector<Choice> choices;
  for (const cases::Target target : {cases::Target::i386, cases::Target::i8088}) {
    if (target == cases::Target::i386 && (cpu == i8088 || cpu == i286)) continue;
    for (const bool mul : {true, false}) {
      for (const bool div : {true, false}) {
        for (const Turning& turning : turnings) {
          choices.push_back({{.target = target, .mul_round = mul, .div_round = div}, turning});
        }
      }
    }
  }
  return choices;
}

std::vector<Choice> measured_choices(std::span<const Choice> choices) {
  std::vector<Choice> measured;
  const auto add = [&measured](Choice choice, std::int32_t every) {
    choice.turning.restore_every = every;
    if (std::ranges::find(measured, choice) == measured.end()) measured.push_back(choice);
  };
  for (const Choice& choice : choices) {
    const std::int32_t every = choice.turning.restore_every;
    if (every > 1) add(choice, 0);
    add(choice, std::min(every, 1));
  }
  return measured;
}

std::vector<double> figures_of(Choice choice, std::span<const Choice> measured,
                               const std::vector<std::vector<double>>& figures) {
  const auto figures_restoring = [&](std::int32_t every) {
    choice.turning.restore_every = every;
    const auto found = std::ranges::find(measured, choice);
    return figures.at(static_cast<std::size_t>(found - measured.begin()));
  };
  const std::int32_t every = choice.turning.restore_every;
  if (every <= 1) return figures_restoring(every);
  std::vector<double> shared = figures_restoring(0);
  const std::vector<double> always = figures_restoring(1);
  for (std::size_t i = 0; i < shared.size(); ++i) shared[i] += (always[i] - shared[i]) / every;
  return shared;
}

std::string name_of(const Choice& choice) {
  const auto on = [](bool rounds) { return rounds ? "on" : "off"; };
  return fmt::format("{} code, multiply {}, divide {}, {}",
                     choice.build.target == cases::Target::i386 ? "386" : "8088",
                     on(choice.build.mul_round), on(choice.build.div_round),
                     name_of(choice.turning));
}

xsharp::Scene scene_with(xsharp::Scene scene, const Choice& choice, const std::string& by) {
  cases::Build build = choice.build;
  build.repaired =
      scene.arithmetic.repaired && cases::can_be_repaired(cases::Operation::concat, build.target);
  scene.arithmetic = player::arithmetic_of(build, by);
  scene.from_scratch = choice.turning.from_scratch;
  scene.restore_every = choice.turning.restore_every;
  return scene;
}

}  // namespace fixproof::trade
