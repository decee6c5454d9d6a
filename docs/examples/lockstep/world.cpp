#include "docs/examples/lockstep/world.hpp"

namespace {

using fixproof::record::mark;

constexpr real dt(1.0 / 64);
constexpr real gravity(-9.8125);
constexpr real bounce(-0.75);
constexpr real wall(8);
constexpr real low_wall(-8);
constexpr real reach(1);

void move(Ball& ball, real push) {
  ball.vx += push * dt;
  ball.vy += gravity * dt;
  ball.x += ball.vx * dt;
  ball.y += ball.vy * dt;
}

void keep_inside(real& place, real& speed) {
  if (place < low_wall) {
    place = low_wall;
    speed *= bounce;
  } else if (place > wall) {
    place = wall;
    speed *= bounce;
  }
}

void push_apart(Ball& a, Ball& b) {
  const real dx = a.x - b.x;
  const real dy = a.y - b.y;
  const real square = dx * dx + dy * dy;
  if (square >= reach || square == 0) return;
  const real distance = fixproof::sqrt(square);
  if (distance == 0) return;
  const real push = (reach - distance) / distance;
  a.vx += dx * push;
  a.vy += dy * push;
  b.vx -= dx * push;
  b.vy -= dy * push;
}

}  // namespace

World new_world() {
  World world;
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    world.balls[i].x = real(static_cast<int>(i % 4) * 3 - 5);
    world.balls[i].y = real(static_cast<int>(i / 4) * 3 - 5);
  }
  return world;
}

void step(World& world, std::int64_t frame) {
  fixproof::record::frame(frame);
  mark("wind");
  const real push(wind(frame));
  mark("move");
  for (Ball& ball : world.balls) {
    move(ball, push);
    keep_inside(ball.x, ball.vx);
    keep_inside(ball.y, ball.vy);
  }
  mark("collide");
  for (std::size_t i = 0; i < world.balls.size(); ++i) {
    for (std::size_t j = i + 1; j < world.balls.size(); ++j) {
      push_apart(world.balls[i], world.balls[j]);
    }
  }
}

std::uint32_t checksum(const World& world) {
  std::uint32_t sum = 0;
  for (const Ball& ball : world.balls) {
    for (const real number : {ball.x, ball.y, ball.vx, ball.vy}) {
      sum = sum * 31 + static_cast<std::uint32_t>(number.raw());
    }
  }
  return sum;
}
