#include "trade/advice/choice.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "player/players.hpp"

namespace fixproof::trade {

namespace {

/// The intervals at 60 rotations per second: never, ten seconds, one second, shorter; from scratch.
constexpr std::array<Turning, 6> turnings{
    {{false, 0}, {false, 600}, {false, 60}, {false, 10}, {false, 1}, {true, 0}}};

std::string name_of(const Turning& turning) {
  if (turning.from_scratch) return "from scratch";
  if (turning.restore_every == 0) return "never restored";
  return fmt::format("restored every {}", turning.restore_every);
}

}  // namespace

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
