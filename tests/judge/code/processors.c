// Products and quotients of 16.16 that every compiler of the label `processors` translates, and three
// with a defect. WRONG_A and WRONG_B are a pair of operands whose quotient is near the largest.
#include <stdint.h>

static int64_t product(int32_t a, int32_t b) { return (int64_t)a * b; }

int32_t right_mul(int32_t a, int32_t b) { return (int32_t)((product(a, b) + 0x8000L) >> 16); }

int32_t right_div(int32_t a, int32_t b) { return b == 0 ? 0 : (int32_t)((int64_t)a * 65536 / b); }

int32_t wrong_ties(int32_t a, int32_t b) {
  const int64_t p = product(a, b);
  return right_mul(a, b) - (p < 0 && (p & 0xffff) == 0x8000L ? 1 : 0);
}

int32_t lost_carry(int32_t a, int32_t b) {
  const int64_t p = product(a, b);
  const uint32_t low = (uint32_t)p + 0x8000UL;
  return (int32_t)((uint32_t)(p >> 32) << 16 | low >> 16);
}

int32_t wrong_pair(int32_t a, int32_t b) {
  return right_div(a, b) + (a == WRONG_A && b == WRONG_B ? 1 : 0);
}
