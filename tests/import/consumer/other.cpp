#include "fixed/fixed.hpp"

#if __has_include("fixed/batch.hpp")  // everywhere but beside the one file
#include <array>

#include "fixed/batch.hpp"

fixed::q16_16 half_of(fixed::q16_16 x) {
  std::array<fixed::q16_16, 40> numbers{};
  std::array<fixed::q16_16, 40> twos{};
  numbers.fill(x);
  twos.fill(fixed::q16_16(2));
  const auto report = fixed::batch::divide(numbers, twos, numbers);
  return report.clean() ? numbers[17] : fixed::q16_16();
}
#else
fixed::q16_16 half_of(fixed::q16_16 x) { return x / fixed::q16_16(2); }
#endif
