#include "fixed/fixed.hpp"

#if __has_include("fixed/batch.hpp")  // everywhere but beside the one file
#include <array>

#include "fixed/batch.hpp"

fixproof::q16_16 half_of(fixproof::q16_16 x) {
  std::array<fixproof::q16_16, 40> numbers{};
  std::array<fixproof::q16_16, 40> twos{};
  numbers.fill(x);
  twos.fill(fixproof::q16_16(2));
  const auto report = fixproof::batch::divide(numbers, twos, numbers);
  return report.clean() ? numbers[17] : fixproof::q16_16();
}
#else
fixproof::q16_16 half_of(fixproof::q16_16 x) { return x / fixproof::q16_16(2); }
#endif
