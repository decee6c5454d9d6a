// usage: lockstep LOG FRAMES
// Simulates FRAMES frames, records them in LOG, and prints the checksum of the last state.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "docs/examples/lockstep/world.hpp"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: lockstep LOG FRAMES\n", stderr);
    return 2;
  }
  const fixproof::record::log log(argv[1], {.program = "lockstep"});
  if (!log.good()) {
    std::fprintf(stderr, "lockstep: %s: %s\n", argv[1], log.problem());
    return 2;
  }
  World world = new_world();
  const std::int64_t frames = std::strtoll(argv[2], nullptr, 10);
  for (std::int64_t frame = 0; frame < frames; ++frame) step(world, frame);
  std::printf("%08x\n", static_cast<unsigned>(checksum(world)));
  return log.good() ? 0 : 2;
}
