#include <array>

#include "fixed/batch/batch.hpp"
#include "fixed/fixed.hpp"

fixproof::q16_16 half_of(fixproof::q16_16 x) {
  std::array<fixproof::q16_16, 40> numbers{};
  std::array<fixproof::q16_16, 40> twos{};
  numbers.fill(x);
  twos.fill(fixproof::q16_16(2));
  const auto report = fixproof::batch::divide(numbers, twos, numbers);
  return report.clean() ? numbers[17] : fixproof::q16_16();
}
