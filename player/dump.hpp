/// @file
/// Frames as JSON lines, for tests and other programs.
#pragma once

#include <cstdint>
#include <string>

#include "xsharp/player.hpp"

namespace fixproof::player {

/// One JSON object a line for every object of the frame that was drawn last, in the order of the
/// scene: `frame`, `object`, `order` (its place in the drawing order), `xform` (12 words, object to
/// view, row by row, in units of 2^-16 like all that follows but pixels), `view` ([x, y, z] of each
/// vertex), `screen` ([x, y] of each vertex, ends of normals too, or null where it is clipped),
/// `visible` (indices of the faces drawn, in order). Of an object too far away to be drawn the
/// transform is 0 and the lists are empty.
std::string dump_frame(const xsharp::Player& player, std::uint64_t frame);

}  // namespace fixproof::player
