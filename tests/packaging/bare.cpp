// What a user's first program does, by whatever way the type came: results worked by hand, a
// function among them.
#include "fixed/fixed.hpp"

int main() {
  using fixproof::q16_16;
  const bool is_right = (q16_16(1.5) * q16_16(-2.5)).raw() == -245760 &&
                        (q16_16(1) / q16_16(3)).raw() == 21845 && exp(q16_16(1)).raw() == 178145;
  return is_right ? 0 : 1;
}
