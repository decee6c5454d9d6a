// A small world of balls in a box, as a game in lockstep would compute it. Every machine computes
// every frame from the same inputs, and all must arrive at the same numbers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/record/recorded.hpp"

// Before: `using real = fixproof::q16_16;`.
using real = fixproof::recorded<fixproof::q16_16>;

struct Ball {
  real x, y, vx, vy;
};

struct World {
  std::array<Ball, 16> balls;
};

/// Returns the wind of a frame, in double. This is the mistake of the example.
double wind(std::int64_t frame);

/// Returns balls in a grid, at rest.
World new_world();

/// Computes one frame: wind, gravity, walls, and collisions of the balls.
void step(World& world, std::int64_t frame);

/// Returns a number for the whole state, such as machines in lockstep exchange.
std::uint32_t checksum(const World& world);
