// Operations and functions on numbers in code for a GPU. clang++ compiles it without an SDK.
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
// What clang's own wrapper of <new> calls.
extern "C" __attribute__((device)) void* malloc(__SIZE_TYPE__);
extern "C" __attribute__((device)) void free(void*);

#include "fixed/angle.hpp"
#include "fixed/exponential.hpp"
#include "fixed/formats.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"
#include "fixed/sine.hpp"
#include "fixed/trigonometry.hpp"

using namespace fixproof;

__attribute__((global)) void arithmetic(const q16_16* a, const q16_16* b, q16_16* out) {
  out[0] = *a * *b + *a / *b;
  out[1] = q16_16(q2_30(*a));
}
__attribute__((global)) void functions(const q16_16* a, const q16_16* b, q16_16* out) {
  out[0] = sqrt(*a);
  out[1] = sin(*a);
  out[2] = exp(*a);
  out[3] = log(*a);
  out[4] = atan2(*a, *b);
  out[5] = tan(*a);
}
