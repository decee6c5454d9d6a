// A small world of balls in a box, as a game in lockstep computes it: every machine computes every
// frame from the same inputs, and all must arrive at the same numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "record/recorded.hpp"

// The one change: before, this was `using real = fixproof::q16_16;`.
using real = fixproof::recorded<fixproof::q16_16>;

struct Ball {
  real x, y, vx, vy;
};

struct World {
  std::array<Ball, 16> balls;
};

/// The wind of a frame, in double: the mistake that this example is about.
double wind(std::int64_t frame);

/// Balls in a grid, at rest.
World new_world();

/// One frame: wind, gravity, walls, and the balls among each other.
void step(World& world, std::int64_t frame);

/// A number for the whole state, as machines in lockstep exchange it.
std::uint32_t checksum(const World& world);
