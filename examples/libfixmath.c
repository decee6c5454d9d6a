/* libfixmath as a subject of `fixproof check`: mul, div or sqrt of the cases on standard input. */
#include <inttypes.h>
#include <libfixmath/fix16.h>
#include <stdio.h>
#include <string.h>

int main(int argc, char** argv) {
  const char* operation = argc == 2 ? argv[1] : "";
  char line[256];
  while (fgets(line, sizeof line, stdin)) {
    uint32_t a = 0;
    uint32_t b = 0;
    fix16_t result;
    if (sscanf(line, "%" SCNx32 " %" SCNx32, &a, &b) < 1) return 2;
    if (strcmp(operation, "mul") == 0) {
      result = fix16_mul((fix16_t)a, (fix16_t)b);
    } else if (strcmp(operation, "div") == 0) {
      result = fix16_div((fix16_t)a, (fix16_t)b);
    } else if (strcmp(operation, "sqrt") == 0) {
      result = fix16_sqrt((fix16_t)a);
    } else {
      return 2;
    }
    printf("%08" PRIx32 "\n", (uint32_t)result);
  }
  return 0;
}
