// usage: planted LOG OPERATIONS [operand|order|contraction]
// Records a run in LOG, with a difference 1,000 turns before its end. `contraction` differs only
// between compilers that contract a product and a difference of doubles, and those that do not.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "tests/fixed/record/sim.hpp"

int main(int count, char** arguments) {
  using namespace fixproof;
  using recorder_test::Plant;
  Plant plant = Plant::nothing;
  if (count == 4) {
    const std::string_view name = arguments[3];
    plant = name == "operand"       ? Plant::operand
            : name == "order"       ? Plant::order
            : name == "contraction" ? Plant::contraction
                                    : Plant::nothing;
  }
  if (count < 3 || (count == 4) == (plant == Plant::nothing)) {
    std::fputs("usage: planted LOG OPERATIONS [operand|order|contraction]\n", stderr);
    return 2;
  }
  const std::uint64_t turns = recorder_test::turn_of(std::strtoull(arguments[2], nullptr, 10));
  recorder_test::run(arguments[1], turns, plant, turns - 1000, record::options::from_environment());
  return 0;
}
