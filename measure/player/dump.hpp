/// @file
/// Frames as JSON lines, for tests and other programs.
#pragma once

#include <cstdint>
#include <string>

#include "xsharp/player.hpp"

namespace fixproof::player {

/// Returns one JSON object per line for every object of the last drawn frame, in scene order:
/// `frame`, `object`, `order` (its place in the drawing order), `xform` (12 words, object to view,
/// row-major), `view` ([x, y, z] of each vertex), `screen` ([x, y] of each vertex and of each end
/// of a normal, or null if it is clipped), `visible` (indices of the drawn faces, in order).
/// `xform` and `view` are in units of 2^-16, `screen` in pixels. An object too far away to be drawn
/// has a transform of 0 and empty lists.
std::string dump_frame(const xsharp::Player& player, std::uint64_t frame);

}  // namespace fixproof::player
