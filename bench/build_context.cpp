// Has every program of this folder say in its output what it was built with.
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
