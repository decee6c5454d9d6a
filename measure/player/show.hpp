/// @file
/// Playback of a scene in a window.
#pragma once

#include <cstddef>

#include "xsharp/scene.hpp"

namespace fixproof::player {

/// Plays the scene at its own speed until the window closes or a signal arrives.
/// @return the exit status: 0, or interrupted_status after a signal
/// @throws UsageError if this build has no window support
int show_scene(const xsharp::Scene& scene, bool true_color, std::size_t threads);

}  // namespace fixproof::player
