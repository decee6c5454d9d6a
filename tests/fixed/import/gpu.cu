// One kernel for each operation and function. clang++ compiles it without an SDK.
#if !defined(__NVCC__)
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
// What clang's own wrapper of <new> calls.
extern "C" __attribute__((device)) void* malloc(__SIZE_TYPE__);
extern "C" __attribute__((device)) void free(void*);
#endif

#include "tests/fixed/import/gpu.hpp"

#define KERNEL(name, type, result)                                                   \
  extern "C" __global__ void name##_kernel(const std::int64_t* in, std::int64_t* out) { \
    const auto x = number_of<type>(in[0]);                                           \
    [[maybe_unused]] const auto y = number_of<type>(in[1]);                          \
    [[maybe_unused]] const auto z = number_of<type>(in[2]);                          \
    *out = word(result);                                                             \
  }
#include "tests/fixed/import/gpu_kernels.hpp"
