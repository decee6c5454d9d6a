// Runs one contender of fair/ so many times, for measure/bench/neon.py, which counts the
// instructions of an emulator.
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "measure/bench/fair/contender.hpp"
#include "measure/bench/fair/groups.hpp"

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: instructions OPERATION CONTENDER ELEMENTS TIMES\n", stderr);
    return 2;
  }
  const std::string operation = argv[1];
  const std::string name = argv[2];
  const std::size_t elements = std::strtoull(argv[3], nullptr, 10);
  std::vector<fair::Group> groups;
  fair::add_arithmetic(groups);
  fair::add_angles(groups);
  fair::add_sums(groups);
  for (const fair::Group& group : groups) {
    if (group.shape != "batch" || group.operation != operation) continue;
    const fair::Words words = group.draw(elements);
    for (const fair::Contender& who : group.contenders) {
      if (who.name != name) continue;
      who.make(words, elements, 0)->run(std::strtoull(argv[4], nullptr, 10));
      return 0;
    }
  }
  std::fputs("instructions: no such operation or contender\n", stderr);
  return 2;
}
