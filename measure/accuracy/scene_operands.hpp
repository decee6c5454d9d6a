/// @file
/// Records the operands of the routines in a scene.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "measure/player/model_call.hpp"
#include "verify/cases/build.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::measure {

/// The operands of the calls in some frames of a scene, recorded on the model.
struct SceneOperands {
  cases::Build build;        ///< the listings that made the calls
  std::uint64_t frames = 0;  ///< number of recorded frames
  player::OperandLog log{};
};

/// The number of recorded frames of a scene.
inline constexpr std::uint64_t recorded_frames = 30;
/// The distance between recorded frames. In total they span eleven seconds at 60 frames per second.
/// A prime, so that objects that move every few frames have their proper share.
inline constexpr std::uint64_t frames_between = 23;

/// Plays the scene from its beginning on the model. If `stop` ends the run early, `frames` is the
/// number of frames recorded until then.
/// @throws std::runtime_error naming scene and frame if the frame cannot be drawn
SceneOperands record_scene(const xsharp::Scene& scene, const cases::Build& build,
                           const std::atomic<bool>& stop);

/// Every pair of factors in the scene: those of FixedMul and of the transforms' dot products.
std::vector<std::uint32_t> products_of(const player::OperandLog& log);

/// Every dot product in the scene's transforms, as six words: two vectors of three.
std::vector<std::uint32_t> dots_of(const player::OperandLog& log);

}  // namespace fixproof::measure
