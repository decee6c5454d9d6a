/* FreeType as a subject of `fixproof check`: FT_MulFix, FT_DivFix, FT_MulDiv, or the sine, cosine or
   tangent of an angle in degrees, of the cases on standard input. FT_Long has 64 bits on most
   systems: what a caller keeps in 32 bits is the low half of it. With `long` after the operation the
   whole is written, in decimal. */
#include <freetype/freetype.h>
#include <freetype/fttrigon.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

int main(int argc, char** argv) {
  const char* operation = argc > 1 ? argv[1] : "";
  const int whole = argc > 2 && strcmp(argv[2], "long") == 0;
  char line[256];
  while (fgets(line, sizeof line, stdin)) {
    uint32_t a = 0;
    uint32_t b = 0;
    uint32_t c = 0;
    FT_Long result;
    if (sscanf(line, "%" SCNx32 " %" SCNx32 " %" SCNx32, &a, &b, &c) < 1) return 2;
    if (strcmp(operation, "mul") == 0) {
      result = FT_MulFix((int32_t)a, (int32_t)b);
    } else if (strcmp(operation, "div") == 0) {
      result = FT_DivFix((int32_t)a, (int32_t)b);
    } else if (strcmp(operation, "mul_div") == 0) {
      result = FT_MulDiv((int32_t)a, (int32_t)b, (int32_t)c);
    } else if (strcmp(operation, "sin_of_degrees") == 0) {
      result = FT_Sin((int32_t)a);
    } else if (strcmp(operation, "cos_of_degrees") == 0) {
      result = FT_Cos((int32_t)a);
    } else if (strcmp(operation, "tan_of_degrees") == 0) {
      result = FT_Tan((int32_t)a);
    } else {
      return 2;
    }
    if (whole) {
      printf("%ld\n", result);
    } else {
      printf("%08" PRIx32 "\n", (uint32_t)result);
    }
  }
  return 0;
}
