/* LLVM's fixed-point functions as a subject of `fixproof check`. GCC for x86 lacks the types, so no
   build of this project has it: clang-19 -ffixed-point stdfix.c libllvmlibc.a */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* A function of words. Debian packages no header for the functions. */
#define FUNCTION(name, type, word)              \
  type name(type);                              \
  static uint64_t word_of_##name(uint64_t in) { \
    word bits = (word)in;                       \
    type value;                                 \
    memcpy(&value, &bits, sizeof value);        \
    value = name(value);                        \
    memcpy(&bits, &value, sizeof bits);         \
    return bits;                                \
  }
FUNCTION(expk, _Accum, uint32_t)
FUNCTION(exphk, short _Accum, uint16_t)
FUNCTION(sqrtuk, unsigned _Accum, uint32_t)
FUNCTION(sqrtuhk, unsigned short _Accum, uint16_t)
FUNCTION(sqrtulr, unsigned long _Fract, uint32_t)
FUNCTION(sqrtur, unsigned _Fract, uint16_t)
FUNCTION(sqrtuhr, unsigned short _Fract, uint8_t)

#define ROW(name, digits) \
  { #name, digits, word_of_##name }
static const struct {
  const char* name;
  int digits;
  uint64_t (*of)(uint64_t);
} functions[] = {ROW(expk, 8),    ROW(exphk, 4),  ROW(sqrtuk, 8), ROW(sqrtuhk, 4),
                 ROW(sqrtulr, 8), ROW(sqrtur, 4), ROW(sqrtuhr, 2)};

int main(int argc, char** argv) {
  for (size_t i = 0; i < sizeof functions / sizeof functions[0]; ++i) {
    if (argc != 2 || strcmp(argv[1], functions[i].name) != 0) continue;
    uint64_t word;
    while (scanf("%" SCNx64, &word) == 1) {
      printf("%0*" PRIx64 "\n", functions[i].digits, functions[i].of(word));
    }
    return 0;
  }
  return 2;
}
