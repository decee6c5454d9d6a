/// @file
/// The ways to draw a scene that `advise` compares.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "verify/cases/variant.hpp"
#include "x86model/clocks.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// How an object gets its orientation in each frame.
struct Turning {
  bool from_scratch = false;       ///< computed anew instead of from the previous frame
  std::int32_t restore_every = 0;  ///< rotations between orthogonality restorations; 0: never

  friend bool operator==(const Turning&, const Turning&) = default;
};

/// `from scratch`, `never restored` or `restored every 60`.
std::string name_of(const Turning& turning);

/// A build of the listings and a way of turning.
struct Choice {
  cases::Build build{};  ///< for i386 or i8088; scene_with() decides about the repair
  Turning turning{};

  friend bool operator==(const Choice&, const Choice&) = default;
};

/// All choices that `cpu` can run, or all choices if it is empty. An 8088 or a 286 has no 32-bit
/// registers and cannot run 386 code.
std::vector<Choice> choices_on(std::optional<x86model::Cpu> cpu);

/// The choices whose figures are measured. Restorations at an interval need two of them, never and
/// after every rotation: see figures_of().
std::vector<Choice> measured_choices(std::span<const Choice> choices);

/// The figures of a choice from those of `measured`. Rare restorations take too little time to
/// measure, so those after every rotation are shared out among the frames between two of them.
std::vector<double> figures_of(Choice choice, std::span<const Choice> measured,
                               const std::vector<std::vector<double>>& figures);

/// `8088 code, multiply on, divide off, restored every 60`.
std::string name_of(const Choice& choice);

/// The scene with this choice. 8088 code is repaired if the scene's arithmetic is.
/// @param by "type" or "model"
xsharp::Scene scene_with(xsharp::Scene scene, const Choice& choice, const std::string& by);

}  // namespace fixproof::trade
