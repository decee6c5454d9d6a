// The two builds compile this source with different options: -ffast-math lets the compiler change
// the order of additions.
#include <array>
#include <cstdint>

#include "docs/examples/lockstep/world.hpp"

double wind(std::int64_t frame) {
  // Large terms cancel, and small ones remain.
  std::array<double, 8> gusts{};
  for (std::size_t i = 0; i < gusts.size(); ++i) {
    const std::int64_t turn = (frame / 64 + static_cast<std::int64_t>(i) * 37) % 101 - 50;
    gusts[i] = (i % 2 == 0 ? 1e13 : -1e13) + static_cast<double>(turn) / 3;
  }
  double sum = 0;
  for (const double gust : gusts) sum += gust;
  // Calm until frame 3000.
  return frame < 3000 ? 0.0 : sum;
}
