// Adds the compiler and its flags to the output of every benchmark.
#include <benchmark/benchmark.h>

namespace {

#if defined(__clang__)
constexpr const char* compiler = "clang++ " __clang_version__;
#else
constexpr const char* compiler = "g++ " __VERSION__;
#endif

// NOLINTNEXTLINE(cert-err58-cpp): without memory there is nothing to measure
[[maybe_unused]] const bool told = []() noexcept {
  benchmark::AddCustomContext("compiler", compiler);
  benchmark::AddCustomContext("flags", FLAGS);
  return true;
}();

}  // namespace
