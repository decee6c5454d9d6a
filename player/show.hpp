/// @file
/// A scene in a window.
#pragma once

#include <cstddef>

#include "xsharp/scene.hpp"

namespace fixproof::player {

/// Plays the scene at its own speed until the window is closed or a signal comes.
/// @return the exit status: 0, or interrupted_status after a signal
/// @throws UsageError where there can be no window
int show_scene(const xsharp::Scene& scene, bool true_color, std::size_t threads);

}  // namespace fixproof::player
