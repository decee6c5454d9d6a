/// @file
/// The operands that the routines meet in a scene.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cases/build.hpp"
#include "player/model_call.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::measure {

/// What the calls of some frames of a scene were given, on the model.
struct SceneOperands {
  cases::Build build;        ///< the listings that made the calls
  std::uint64_t frames = 0;  ///< recorded
  player::OperandLog log{};
};

/// A scene is recorded in this many frames ...
inline constexpr std::uint64_t recorded_frames = 30;
/// ... of which each is this many after the last, from eleven seconds at 60 a second. A prime, so
/// that objects that move every few frames move in as many of these as they should.
inline constexpr std::uint64_t frames_between = 23;

/// Plays the scene from its beginning on the model. If `stop` ends the run early, `frames` says so.
/// @throws std::runtime_error naming scene and frame where it cannot be drawn
SceneOperands record_scene(const xsharp::Scene& scene, const cases::Build& build,
                           const std::atomic<bool>& stop);

/// Every pair that a scene multiplies: in FixedMul, and in the sums of the transforms.
std::vector<std::uint32_t> products_of(const player::OperandLog& log);

/// Every sum of three products that a scene forms in its transforms: six words, of which the first
/// three are multiplied with the last three.
std::vector<std::uint32_t> dots_of(const player::OperandLog& log);

}  // namespace fixproof::measure
