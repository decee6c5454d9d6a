/// @file
/// What differs in code for a GPU.
#pragma once

#include "fixed/detail/standard.hpp"

/// Defined where the compiler makes code for a GPU, not for the processor that starts it.
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
#define FIXED_GPU
#endif

/// Begins the definition of a constant whose address code needs: an array, an object, an argument
/// of a reference. nvcc puts it into the memory of the GPU only if it says so, and refuses it
/// inline; without that, nvcc reads from address 0. clang++ does so by itself.
#if defined(FIXED_GPU) && defined(__NVCC__)
#define FIXED_CONSTANT constexpr __device__
#else
#define FIXED_CONSTANT inline constexpr
#endif
