#include "measure/player/players.hpp"

#include <fmt/format.h>

#include <utility>

#include "support/usage_error.hpp"
#include "verify/cases/variant.hpp"
#include "xsharp/animation.hpp"

namespace fixproof::player {

using xsharp::ArithmeticChoice;

std::optional<cases::Build> build_of(const ArithmeticChoice& choice) {
  if (choice.by == "double") return std::nullopt;
  for (const auto target : {cases::Target::i386, cases::Target::i8088, cases::Target::standard}) {
    if (cases::name_of(target) != choice.target) continue;
    return cases::Build{.target = target,
                        .mul_round = choice.mul_round,
                        .div_round = choice.div_round,
                        .repaired = choice.repaired};
  }
  return std::nullopt;
}

ArithmeticChoice arithmetic_of(const cases::Build& build, std::string by) {
  return {std::move(by), std::string(cases::name_of(build.target)), build.mul_round,
          build.div_round, build.repaired};
}

std::string name_of(const ArithmeticChoice& choice) {
  if (choice.by == "double") return "double";
  if (!xsharp::is_listing(choice)) {
    return fmt::format("{} {}", choice.by, choice.target);
  }
  const auto on = [](bool rounds) { return rounds ? "on" : "off"; };
  return fmt::format("{} {}{}, multiply {}, divide {}", choice.by, choice.target,
                     choice.repaired ? " repaired" : "", on(choice.mul_round),
                     on(choice.div_round));
}

support::UsageError no_arithmetic(const ArithmeticChoice& choice) {
  const std::string_view others = choice.by == "type" ? ", standard, saturating, trapping" : "";
  return support::UsageError{fmt::format("{} has no target {}; choose one of i386, i8088{}",
                                         choice.by, choice.target, others)};
}

std::unique_ptr<xsharp::Player> make_player(const xsharp::Scene& scene,
                                            const ArithmeticChoice& choice, std::size_t threads) {
  if (choice.by == "double") return std::make_unique<xsharp::Animation<double>>(scene, threads);
  if (choice.by == "model" && threads > 1) {
    throw support::UsageError(fmt::format(
        "--threads {}: the model takes 1 thread, because its calls are counted", threads));
  }
  auto player = choice.by == "model"  ? make_model_player(scene, choice)
                : choice.by == "type" ? make_type_player(scene, choice, threads)
                                      : nullptr;
  if (!player) throw no_arithmetic(choice);
  return player;
}

}  // namespace fixproof::player
