/* A textbook CORDIC of 32 bits in 16.16, as a subject of `fixproof check`: sin, cos, exp, atan or
   atan2 of the cases on standard input. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { STEPS = 29, PI = 1686629713, LN2 = 372130559 };
enum { GAIN = 326016437, HYPERBOLIC_GAIN = 648270052 }; /* of all steps, inverse */

/* atan and atanh of 2^-i for the steps before 10. Later ones are 2^-i. */
static const int32_t atans[10] = {421657428, 248918915, 131521918, 66762579, 33510843,
                                  16771758,  8387925,   4194219,   2097141,  1048575};
static const int32_t atanhs[10] = {0,        294906491, 137123709, 67461703, 33598225,
                                   16782681, 8389291,   4194389,   2097163,  1048577};

/* With 29 bits after the point. */
typedef struct {
  int32_t x, y, z;
} Vector;

/* Turns v until its angle z is 0 or, to measure its angle, until y is 0. */
static Vector turn(Vector v, int measure, int hyperbolic) {
  int again = 4;
  for (int i = hyperbolic; i < STEPS; ++i) {
    const int up = measure ? v.y < 0 : v.z >= 0;
    const int32_t dx = v.y >> i, dy = v.x >> i;
    const int32_t dz = i >= 10 ? 1 << (29 - i) : hyperbolic ? atanhs[i] : atans[i];
    v.x += up == hyperbolic ? dx : -dx;
    v.y += up ? dy : -dy;
    v.z -= up ? dz : -dz;
    /* Without steps 4 and 13 twice it does not reach every hyperbolic angle. */
    if (hyperbolic && i == again) again = 3 * i-- + 1;
  }
  return v;
}

static int32_t rounded(int64_t v, int n) { return (int32_t)((v + (1LL << n >> 1)) >> n); }

static int32_t sine(int32_t angle, int is_cosine) {
  angle %= 411775; /* 2 pi */
  const int half_turns =
      (angle > 102944) + (angle > 308831) - (angle < -102944) - (angle < -308831);
  const int64_t rest = angle * INT64_C(8192) - half_turns * (int64_t)PI;
  const Vector v = turn((Vector){GAIN, 0, (int32_t)rest}, 0, 0);
  const int32_t result = rounded(is_cosine ? v.x : v.y, 13);
  return half_turns % 2 ? -result : result;
}

static int32_t arctangent(int32_t b, int32_t a) {
  const int64_t sign = a < 0 ? -1 : 1;
  int64_t x = sign * a, y = sign * b;
  if (x == 0 && y == 0) return 0;
  for (; x < 1 << 28 && y < 1 << 28 && y > -(1 << 28); y *= 2) x *= 2;
  for (; x >= 1 << 29 || y >= 1 << 29 || y <= -(1 << 29); y /= 2) x /= 2;
  const int32_t start = a >= 0 ? 0 : b >= 0 ? PI : -PI;
  return rounded(turn((Vector){(int32_t)x, (int32_t)y, start}, 1, 0).z, 13);
}

static int32_t exponential(int32_t a) {
  if (a > 681391) return INT32_MAX;
  if (a < -772243) return 0;
  const int power = (int)(a * INT64_C(94548) >> 32); /* of two; 94548 is 1 / ln 2 */
  const int64_t rest = a * INT64_C(8192) - power * (int64_t)LN2;
  const Vector v = turn((Vector){HYPERBOLIC_GAIN, 0, (int32_t)rest}, 0, 1);
  return rounded((int64_t)(v.x + v.y) << 4, 17 - power);
}

int main(int argc, char** argv) {
  const char* name = argc == 2 ? argv[1] : "";
  uint32_t a, b = 65536;
  while (scanf("%" SCNx32 "%*[ ]%" SCNx32, &a, &b) > 0) {
    const int32_t result = strcmp(name, "sin") == 0   ? sine((int32_t)a, 0)
                           : strcmp(name, "cos") == 0 ? sine((int32_t)a, 1)
                           : strcmp(name, "exp") == 0 ? exponential((int32_t)a)
                                                      : arctangent((int32_t)a, (int32_t)b);
    printf("%08" PRIx32 "\n", (uint32_t)result);
  }
  return 0;
}
