#include <iostream>

#include "fixed/fixed.hpp"

int main() {
  using fixed::q16_16;
  std::cout << q16_16(1.5) * q16_16(-2.5) << '\n';
  return q16_16(1.5) * q16_16(-2.5) == q16_16(-3.75) ? 0 : 1;
}
