/* Functions for `fixproof verify --against ./libmine.so:NAME`: 16.16, half up, wrapping. */
#include <stddef.h>
#include <stdint.h>

/* A product has 32 fraction bits. The half that is added is worth 2^-17, half a unit of 16.16. */
int32_t my_mul(int32_t a, int32_t b) { return (int32_t)(((int64_t)a * b + 0x8000) >> 16); }

/* The same for arrays, which a compiler may compute with vector registers. */
void my_muls(const int32_t a[], const int32_t b[], int32_t result[], size_t count) {
  for (size_t i = 0; i < count; ++i) result[i] = my_mul(a[i], b[i]);
}

/* Wrong: it rounds down. */
int32_t my_mul_down(int32_t a, int32_t b) { return (int32_t)((int64_t)a * b >> 16); }
