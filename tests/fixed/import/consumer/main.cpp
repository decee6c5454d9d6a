// The example of fixed/fixed.hpp, and the header in two translation units.
#include <iostream>

#include "fixed/fixed.hpp"

fixproof::q16_16 half_of(fixproof::q16_16 x);

int main() {
  using fixproof::q16_16;
  constexpr q16_16 half(0.5);
  constexpr q16_16 x = q16_16(7) / q16_16(2) + half;
  static_assert(x == q16_16(4) && x.raw() == 0x40000);
  const auto [sin, cos] = fixproof::sin_cos_of_tenths<q16_16>(450);
  std::cout << x * cos << '\n';
  const fixproof::q16_16_saturating far(1e9);
  const bool right = fixproof::to_string(x * cos) == "2.82843017578125" && cos == sin &&
                     fixproof::to_string(far) == "32767.9999847412109375" &&
                     !fixproof::try_divide(x, q16_16()) && half_of(x) == q16_16(2);
  return right ? 0 : 1;
}
