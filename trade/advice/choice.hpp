/// @file
/// The ways in which a scene can be drawn, from which one is to be taken.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/variant.hpp"
#include "x86model/clocks.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// How the orientation of an object follows from that of the frame before.
struct Turning {
  bool from_scratch = false;       ///< it does not: worked out anew
  std::int32_t restore_every = 0;  ///< rotations between two restorings of orthogonality; 0: never

  friend bool operator==(const Turning&, const Turning&) = default;
};

/// A build of the listings, and a way of turning.
struct Choice {
  cases::Target target = cases::Target::i386;  ///< i386 or i8088
  bool mul_round = true;
  bool div_round = true;
  Turning turning{};

  friend bool operator==(const Choice&, const Choice&) = default;
};

/// All that a processor can run: an 8088 or a 286 has no 32-bit registers. Without one, all.
std::vector<Choice> choices_on(std::optional<x86model::Cpu> cpu);

/// `8088 code, multiply on, divide off, restored every 60`.
std::string name_of(const Choice& choice);

/// The arithmetic of a choice, by the type or the model.
xsharp::ArithmeticChoice arithmetic_of(const Choice& choice, const std::string& by);

/// The scene, drawn as chosen by the type or the model. 8088 code is repaired where the scene's
/// arithmetic says so.
xsharp::Scene scene_with(xsharp::Scene scene, const Choice& choice, const std::string& by);

}  // namespace fixproof::trade
