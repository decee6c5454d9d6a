/* libfixmath as a subject of `fixproof check`: one operation, for the cases on standard input. */
#include <inttypes.h>
#include <libfixmath/fix16.h>
#include <stdio.h>
#include <string.h>

static double double_of(uint64_t bits) {
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

struct function {
  const char* name;
  fix16_t (*of)(fix16_t);
};

/* The functions of one number, by the name that `fixproof check` gives them. */
static const struct function functions[] = {
    {"exp", fix16_exp},   {"log", fix16_log},   {"log2", fix16_log2}, {"sin", fix16_sin},
    {"cos", fix16_cos},   {"tan", fix16_tan},   {"asin", fix16_asin}, {"acos", fix16_acos},
    {"atan", fix16_atan}, {"sqrt", fix16_sqrt},
};

static const struct function* function_named(const char* name) {
  for (size_t i = 0; i < sizeof functions / sizeof functions[0]; ++i) {
    if (strcmp(name, functions[i].name) == 0) return &functions[i];
  }
  return NULL;
}

int main(int argc, char** argv) {
  const char* operation = argc == 2 ? argv[1] : "";
  const struct function* function = function_named(operation);
  char line[256];
  while (fgets(line, sizeof line, stdin)) {
    uint64_t a = 0;
    uint32_t b = 0;
    fix16_t result;
    sscanf(line, "%" SCNx64 " %" SCNx32, &a, &b);
    if (function) {
      result = function->of((fix16_t)a);
    } else if (strcmp(operation, "mul") == 0) {
      result = fix16_mul((fix16_t)a, (fix16_t)b);
    } else if (strcmp(operation, "div") == 0) {
      result = fix16_div((fix16_t)a, (fix16_t)b);
    } else if (strcmp(operation, "atan2") == 0) {
      result = fix16_atan2((fix16_t)a, (fix16_t)b);
    } else if (strcmp(operation, "from_binary64") == 0) {
      result = fix16_from_dbl(double_of(a));
    } else if (strcmp(operation, "from_decimal") == 0) {
      result = fix16_from_str(line);
    } else if (strcmp(operation, "to_decimal") == 0) {
      fix16_to_str((fix16_t)a, line, 5);
      puts(line);
      continue;
    } else {
      return 2;
    }
    printf("%08" PRIx32 "\n", (uint32_t)result);
  }
  return 0;
}
