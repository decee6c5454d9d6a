// Times the limits of this processor: multiplies, divides and roots with each kind of instruction
// that the type's operations use, loads and stores in the first-level cache, and copies. Operations
// are independent, so this measures throughput. Times are per result or byte, as in the other
// benchmarks. Checks no results.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace {

/// Unrolled steps, so that the loop overhead is not timed.
constexpr int unrolled = 16;
constexpr int rounds = 100;

/// Keeps the value in a register and hides it from the compiler. benchmark::DoNotOptimize also
/// allows memory, which clang chooses; that would time store-to-load forwarding.
template <class Value>
void hide(Value& value) {
#if defined(__x86_64__)
  if constexpr (std::is_floating_point_v<Value>) {
    asm volatile("" : "+x"(value));
  } else {
    asm volatile("" : "+r"(value));
  }
#else
  benchmark::DoNotOptimize(value);
#endif
}

template <class Value, class Step>
void throughput(benchmark::State& state, Value value, Step step) {
  for ([[maybe_unused]] auto _ : state) {
    for (int round = 0; round < rounds; ++round) {
      for (int i = 0; i < unrolled; ++i) {
        hide(value);
        Value result = step(value);
        hide(result);
      }
    }
  }
  state.SetItemsProcessed(state.iterations() * rounds * unrolled);
}

// Hides the operand, because the compiler could optimise a multiply or divide by a constant.
void multiply_scalar(benchmark::State& state) {
  std::uint64_t factor = 0x12345;
  hide(factor);
  throughput(state, std::uint64_t{0x1234567}, [factor](std::uint64_t x) { return x * factor; });
}
BENCHMARK(multiply_scalar);

void divide_64_by_64(benchmark::State& state) {
  // As large as a shifted 16.16 numerator, with a quotient of 32 bits.
  std::int64_t divisor = 0x12345;
  hide(divisor);
  throughput(state, std::int64_t{0x712345678123},
             [divisor](std::int64_t x) { return x / divisor; });
}
BENCHMARK(divide_64_by_64);

void divide_double(benchmark::State& state) {
  double divisor = 1.0000001;
  hide(divisor);
  throughput(state, 3.7, [divisor](double x) { return x / divisor; });
}
BENCHMARK(divide_double);

#if defined(__x86_64__)

// A lambda does not inherit its function's target attribute, so these loops are macros. The asm
// does the same as hide().

// GCC warns that std::array of vectors drops their attributes.
// NOLINTBEGIN(cppcoreguidelines-macro-usage,bugprone-macro-parentheses,*-avoid-c-arrays)

/// `step` uses `value` and `other`.
#define VECTOR_LIMIT(name, instructions, Value, start, operand, step)             \
  __attribute__((target(instructions))) void name(benchmark::State& state) {      \
    Value value = start;                                                          \
    [[maybe_unused]] const Value other = operand;                                 \
    for ([[maybe_unused]] auto _ : state) {                                       \
      for (int round = 0; round < rounds; ++round) {                              \
        for (int i = 0; i < unrolled; ++i) {                                      \
          asm volatile("" : "+x"(value));                                         \
          const Value result = step;                                              \
          asm volatile("" : : "x"(result));                                       \
        }                                                                         \
      }                                                                           \
    }                                                                             \
    constexpr int lanes = sizeof(Value) / sizeof(double);                         \
    state.SetItemsProcessed(state.iterations() * rounds * unrolled * int{lanes}); \
  }

/// `step` loads `value` from `at[i]` or stores it there.
#define MEMORY_LIMIT(name, instructions, Value, step)                                     \
  __attribute__((target(instructions))) void name(benchmark::State& state) {              \
    Value block[unrolled] = {};                                                           \
    Value value = block[0];                                                               \
    Value* at = block;                                                                    \
    asm volatile("" : "+r"(at));                                                          \
    for ([[maybe_unused]] auto _ : state) {                                               \
      for (int round = 0; round < rounds; ++round) {                                      \
        for (int i = 0; i < unrolled; ++i) {                                              \
          step;                                                                           \
          asm volatile("" : "+x"(value) : : "memory");                                    \
        }                                                                                 \
      }                                                                                   \
    }                                                                                     \
    state.SetBytesProcessed(state.iterations() * rounds * unrolled * int{sizeof(Value)}); \
  }

VECTOR_LIMIT(multiply_avx2, "avx2", __m256i, _mm256_set1_epi64x(0x1234567),
             _mm256_set1_epi64x(0x12345), _mm256_mul_epi32(value, other))
VECTOR_LIMIT(divide_double_avx2, "avx2", __m256d, _mm256_set1_pd(3.7), _mm256_set1_pd(1.0000001),
             _mm256_div_pd(value, other))
VECTOR_LIMIT(root_double_avx2, "avx2", __m256d, _mm256_set1_pd(3.7), value, _mm256_sqrt_pd(value))
MEMORY_LIMIT(load_avx2, "avx2", __m256i, value = at[i])
MEMORY_LIMIT(store_avx2, "avx2", __m256i, at[i] = value)

// GCC 12 warns of uninitialised lanes in the forms without a mask.
VECTOR_LIMIT(multiply_avx512, "avx512f", __m512i, _mm512_set1_epi64(0x1234567),
             _mm512_set1_epi64(0x12345), _mm512_maskz_mul_epi32(0xFF, value, other))
VECTOR_LIMIT(divide_double_avx512, "avx512f", __m512d, _mm512_set1_pd(3.7),
             _mm512_set1_pd(1.0000001), _mm512_div_pd(value, other))
VECTOR_LIMIT(root_double_avx512, "avx512f", __m512d, _mm512_set1_pd(3.7), value,
             _mm512_maskz_sqrt_pd(0xFF, value))
MEMORY_LIMIT(load_avx512, "avx512f", __m512i, value = at[i])
MEMORY_LIMIT(store_avx512, "avx512f", __m512i, at[i] = value)
#undef VECTOR_LIMIT
#undef MEMORY_LIMIT
// NOLINTEND(cppcoreguidelines-macro-usage,bugprone-macro-parentheses,*-avoid-c-arrays)

// NOLINTNEXTLINE(cert-err58-cpp): without memory there is nothing to measure
[[maybe_unused]] const bool registered = [] {
  if (__builtin_cpu_supports("avx2")) {
    benchmark::RegisterBenchmark("multiply_avx2", multiply_avx2);
    benchmark::RegisterBenchmark("divide_double_avx2", divide_double_avx2);
    benchmark::RegisterBenchmark("root_double_avx2", root_double_avx2);
    benchmark::RegisterBenchmark("load_avx2", load_avx2);
    benchmark::RegisterBenchmark("store_avx2", store_avx2);
  }
  if (__builtin_cpu_supports("avx512f")) {
    benchmark::RegisterBenchmark("multiply_avx512", multiply_avx512);
    benchmark::RegisterBenchmark("divide_double_avx512", divide_double_avx512);
    benchmark::RegisterBenchmark("root_double_avx512", root_double_avx512);
    benchmark::RegisterBenchmark("load_avx512", load_avx512);
    benchmark::RegisterBenchmark("store_avx512", store_avx512);
  }
  return true;
}();

#endif

/// Copies `state.range(0)` bytes, in the caches and in memory.
void copy(benchmark::State& state) {
  const std::vector<unsigned char> from(static_cast<std::size_t>(state.range(0)), 7);
  std::vector<unsigned char> to(from.size());
  for ([[maybe_unused]] auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * state.range(0));
}
BENCHMARK(copy)->Arg(16 << 10)->Arg(256 << 10)->Arg(8 << 20)->Arg(256 << 20);

}  // namespace
