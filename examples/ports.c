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

/* Build, Rise of the Triad and Descent: IDIV. */
static int64_t divided(int64_t a, int64_t b) {
  if (b == 0) return DE;
  const int64_t x = a * 65536 / b;
  return x < INT32_MIN || x > INT32_MAX ? DE : x;
}

/* Doom. abs() of the lowest number is that number, which is below all others. */
static int64_t doom_size(int64_t x) { return x == INT32_MIN ? x : size(x); }
static int64_t guarded(int64_t a, int64_t b) {
  if (doom_size(a) >> 14 >= doom_size(b)) return (a ^ b) < 0 ? INT32_MIN : INT32_MAX;
  return divided(a, b);
}

/* Allegro on the 386. */
static int64_t truncated(int64_t a, int64_t b) {
  const bool negative = (a < 0) != (b < 0);
  const int64_t x = b == 0 ? INT64_MAX : size(a) * 65536 / size(b);
  const int64_t kept = x > INT32_MAX ? INT32_MAX : x;
  return negative ? -kept : kept;
}

/* Allegro in C. */
static int64_t rounded(int64_t a, int64_t b) {
  if (b == 0) return a < 0 ? -INT32_MAX : INT32_MAX;
  const double x = (double)a / (double)b;
  if (x > 32767.0 || x < -32767.0) return x < 0 ? -INT32_MAX : INT32_MAX;
  return (int64_t)(x * 65536.0 + (x < 0 ? -0.5 : 0.5));
}

static const struct {
  const char* rule;
  const char* operation;
  int64_t (*function)(int64_t, int64_t);
} ports[] = {
    {"doom", "mul", floored},           {"doom", "div", guarded},
    {"build", "mul", floored},          {"build", "div", divided},
    {"rott", "mul", half_up},           {"rott", "div", divided},
    {"descent", "mul", floored},        {"descent", "div", divided},
    {"allegro-i386", "mul", saturated}, {"allegro-i386", "div", truncated},
    {"allegro-c", "div", rounded},      {"wolf3d", "mul", by_fraction},
};

int main(int argc, char** argv) {
  char line[256];
  for (size_t i = 0; argc == 3 && i < sizeof ports / sizeof *ports; ++i) {
    if (strcmp(argv[1], ports[i].rule) != 0 || strcmp(argv[2], ports[i].operation) != 0) continue;
    while (fgets(line, sizeof line, stdin)) {
      uint32_t a = 0;
      uint32_t b = 0;
      if (sscanf(line, "%" SCNx32 " %" SCNx32, &a, &b) != 2) return 2;
      const int64_t result = ports[i].function((int32_t)a, (int32_t)b);
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
