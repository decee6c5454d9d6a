/// @file
/// The origin of a log: lines `name: value` for its first page.
#pragma once

#include <cfloat>
#include <string>
#include <string_view>

#include "fixed/version.hpp"

namespace fixproof::record {

/// Returns the program, the library, the compiler, the processor, and the compiler's options that
/// affect the floating-point code around the type.
inline std::string origin(std::string_view program) {
  std::string text = "program: ";
  for (const char c : program.substr(0, 200)) {
    text += static_cast<unsigned char>(c) < ' ' ? '?' : c;  // `char` may be signed or not
  }
  text += "\nlibrary: fixproof " + std::to_string(FIXED_VERSION_MAJOR) + '.' +
          std::to_string(FIXED_VERSION_MINOR) + '.' + std::to_string(FIXED_VERSION_PATCH);
  text += "\ncompiler: ";
#if defined(__clang__)
  text += "clang++ " __clang_version__;
#elif defined(__GNUC__)
  text += "g++ " __VERSION__;
#elif defined(_MSC_VER)
  text += "MSVC " + std::to_string(_MSC_VER);
#else
  text += "unknown";
#endif
  text += "\nprocessor: ";
#if defined(__x86_64__) || defined(_M_X64)
  text += "x86_64";
#elif defined(__i386__) || defined(_M_IX86)
  text += "i686";
#elif defined(__aarch64__) || defined(_M_ARM64)
  text += "aarch64";
#elif defined(__arm__)
  text += "arm";
#elif defined(__riscv)
  text += "riscv";
#elif defined(__s390x__)
  text += "s390x";
#elif defined(__powerpc64__)
  text += "powerpc64";
#elif defined(__wasm__)
  text += "wasm";
#else
  text += "unknown";
#endif
  text += ", " + std::to_string(8 * sizeof(void*)) + " bits";
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  text += ", big-endian";
#else
  text += ", little-endian";
#endif
  text += "\nfloating point: FLT_EVAL_METHOD ";
  text += std::to_string(FLT_EVAL_METHOD);
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA) || defined(__FP_FAST_FMA)
  text += ", fused multiply-add";
#endif
#if defined(__FAST_MATH__)
  text += ", -ffast-math";
#endif
#if defined(__OPTIMIZE__)
  text += "\noptimised: yes";
#else
  text += "\noptimised: no";
#endif
  return text + '\n';
}

}  // namespace fixproof::record
