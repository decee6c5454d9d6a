/* usage: ports RULE OPERATION: reads cases of `fixproof gen OPERATION`, and writes the results of a
   port for `fixproof check OPERATION --rule RULE`. These are the fixed-point routines of games and of
   Allegro, in C without undefined behavior for any operands; the compiler must shift negative numbers
   arithmetically, as all common ones do. docs/ports.md describes the rules. */
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* A divide error. All other results fit 32 bits. */
#define DE INT64_MAX

static int64_t wrapped(uint64_t x) { return (int32_t)(uint32_t)x; }
static int64_t size(int64_t x) { return x < 0 ? -x : x; }

/* Doom, Build and Descent. */
static int64_t floored(int64_t a, int64_t b) { return wrapped((uint64_t)(a * b >> 16)); }

/* Rise of the Triad. */
static int64_t half_up(int64_t a, int64_t b) { return wrapped((uint64_t)((a * b + 0x8000) >> 16)); }

/* Wolfenstein 3-D: b has its sign in bit 31 and a fraction in bits 0 to 15. */
static int64_t by_fraction(int64_t a, int64_t b) {
  const int64_t x = size(a) * (b & 0xffff) >> 16;
  return (a < 0) != (b < 0) ? -x : x;
}

/* Allegro on the 386. */
static int64_t saturated(int64_t a, int64_t b) {
  const int64_t x = a * b >> 16;
  if (x >= INT32_MIN && x <= INT32_MAX) return x;
  return x < 0 ? -INT32_MAX : INT32_MAX;
}

/* Allegro in C. */
static int64_t clipped(int64_t a, int64_t b) {
  const int64_t x = a * b;
  if (x > INT32_MAX * INT64_C(65536)) return INT32_MAX;
  return x < -INT32_MAX * INT64_C(65536) ? INT32_MIN : x >> 16;
}

/* Build, Rise of the Triad and Descent: IDIV. */
static int64_t idiv(int64_t a, int64_t b) {
  if (b == 0) return DE;
  const int64_t x = a / b;
  return x < INT32_MIN || x > INT32_MAX ? DE : x;
}
static int64_t divided(int64_t a, int64_t b) { return idiv(a * 65536, b); }
static int64_t scaled(int64_t a, int64_t b, int64_t c) { return idiv(a * b, c); }

/* Doom. abs() of the lowest number is that number, which is below all others. */
static int64_t doom_size(int64_t x) { return x == INT32_MIN ? x : size(x); }
static bool is_far(int64_t a, int64_t b) { return doom_size(a) >> 14 >= doom_size(b); }
static int64_t end(int64_t a, int64_t b) { return (a ^ b) < 0 ? INT32_MIN : INT32_MAX; }
static int64_t guarded(int64_t a, int64_t b) { return is_far(a, b) ? end(a, b) : divided(a, b); }

/* Chocolate Doom divides in 64 bits. */
static int64_t guarded_wide(int64_t a, int64_t b) {
  if (is_far(a, b)) return end(a, b);
  return b == 0 ? DE : wrapped((uint64_t)(a * 65536 / b));
}

/* Allegro on the 386. */
static int64_t truncated(int64_t a, int64_t b) {
  const bool negative = (a < 0) != (b < 0);
  const int64_t x = b == 0 ? INT64_MAX : size(a) * 65536 / size(b);
  const int64_t kept = x > INT32_MAX ? INT32_MAX : x;
  return negative ? -kept : kept;
}

/* Allegro in C: ftofix(). */
static int64_t from_double(double x) {
  if (x > 32767.0 || x < -32767.0) return x < 0 ? -INT32_MAX : INT32_MAX;
  return (int64_t)(x * 65536.0 + (x < 0 ? -0.5 : 0.5));
}
static int64_t rounded(int64_t a, int64_t b) {
  if (b == 0) return a < 0 ? -INT32_MAX : INT32_MAX;
  return from_double((double)a / (double)b);
}
static int64_t rounded_product(int64_t a, int64_t b) {
  return from_double((double)a / 65536.0 * ((double)b / 65536.0));
}

static const struct {
  const char* rule;
  const char* operation;
  int64_t (*of_two)(int64_t, int64_t);
  int64_t (*of_three)(int64_t, int64_t, int64_t);
} ports[] = {
    {"doom", "mul", floored, NULL},
    {"doom", "div", guarded, NULL},
    {"chocolate-doom", "mul", floored, NULL},
    {"chocolate-doom", "div", guarded_wide, NULL},
    {"build", "mul", floored, NULL},
    {"build", "div", divided, NULL},
    {"build", "mul_div", NULL, scaled},
    {"rott", "mul", half_up, NULL},
    {"rott", "div", divided, NULL},
    {"rott", "mul_div", NULL, scaled},
    {"descent", "mul", floored, NULL},
    {"descent", "div", divided, NULL},
    {"descent", "mul_div", NULL, scaled},
    {"allegro-i386", "mul", saturated, NULL},
    {"allegro-i386", "div", truncated, NULL},
    {"allegro-c", "mul", clipped, NULL},
    {"allegro-c", "div", rounded, NULL},
    {"allegro-double", "mul", rounded_product, NULL},
    {"wolf3d", "mul", by_fraction, NULL},
};

int main(int argc, char** argv) {
  char line[256];
  for (size_t i = 0; argc == 3 && i < sizeof ports / sizeof *ports; ++i) {
    if (strcmp(argv[1], ports[i].rule) != 0 || strcmp(argv[2], ports[i].operation) != 0) continue;
    while (fgets(line, sizeof line, stdin)) {
      uint32_t a = 0;
      uint32_t b = 0;
      uint32_t c = 0;
      const int read = sscanf(line, "%" SCNx32 " %" SCNx32 " %" SCNx32, &a, &b, &c);
      if (read != (ports[i].of_three ? 3 : 2)) return 2;
      const int64_t result = ports[i].of_three
                                 ? ports[i].of_three((int32_t)a, (int32_t)b, (int32_t)c)
                                 : ports[i].of_two((int32_t)a, (int32_t)b);
      if (result == DE) {
        puts("DE");
      } else {
        printf("%08" PRIx32 "\n", (uint32_t)result);
      }
    }
    return 0;
  }
  fputs("usage: ports RULE OPERATION\n", stderr);
  return 2;
}
