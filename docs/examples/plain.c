/* The common idioms of C, as a subject of `fixproof check`: mul or div of the cases on standard
   input. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static int32_t mul(int32_t a, int32_t b) { return (int32_t)((int64_t)a * b >> 16); }

static int32_t divide(int32_t a, int32_t b) { return (int32_t)((int64_t)a * 65536 / b); }

int main(int argc, char** argv) {
  const char* operation = argc == 2 ? argv[1] : "";
  const int divides = strcmp(operation, "div") == 0;
  char line[256];
  if (!divides && strcmp(operation, "mul") != 0) return 2;
  while (fgets(line, sizeof line, stdin)) {
    uint32_t a = 0;
    uint32_t b = 0;
    if (sscanf(line, "%" SCNx32 " %" SCNx32, &a, &b) != 2) return 2;
    if (divides && b == 0) {
      puts("DE");
    } else {
      const int32_t result = divides ? divide((int32_t)a, (int32_t)b) : mul((int32_t)a, (int32_t)b);
      printf("%08" PRIx32 "\n", (uint32_t)result);
    }
  }
  return 0;
}
