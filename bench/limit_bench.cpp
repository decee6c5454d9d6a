// What this processor can do at most: independent multiplies and divides by each kind of
// instruction that the type's operations are made of, and the bytes it can copy. Times are for one
// result, so that they stand beside those of the other benchmarks.
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace {

/// Chains enough that no result is waited for.
constexpr std::size_t chains = 12;
constexpr int rounds = 100;

/// Makes the compiler keep the value in a register and know nothing of it. benchmark::DoNotOptimize
/// lets it choose memory, and clang does: what is timed then is how a store reaches the next load.
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

/// Times `step` on chains of values that it changes; counts `lanes` results for each.
template <class Value, class Step>
void throughput(benchmark::State& state, std::array<Value, chains> values, int lanes, Step step) {
  for (auto _ : state) {
    for (int round = 0; round < rounds; ++round) {
      for (Value& value : values) {
        value = step(value);
        hide(value);
      }
    }
  }
  state.SetItemsProcessed(state.iterations() * rounds * static_cast<int>(chains) * lanes);
}

// The operand is hidden from the compiler, which could do without a multiply or divide by a
// constant.
void multiply_scalar(benchmark::State& state) {
  std::uint64_t factor = 0x12345;
  hide(factor);
  std::array<std::uint64_t, chains> values;
  values.fill(0x1234567);
  throughput(state, values, 1, [factor](std::uint64_t x) { return x * factor; });
}
BENCHMARK(multiply_scalar);

void divide_64_by_64(benchmark::State& state) {
  // As large as a shifted 16.16 numerator, and a quotient of 32 bits.
  std::int64_t divisor = 0x12345;
  hide(divisor);
  std::array<std::int64_t, chains> values;
  values.fill(0x712345678123);
  throughput(state, values, 1, [divisor](std::int64_t x) { return x / divisor + 0x712345670000; });
}
BENCHMARK(divide_64_by_64);

void divide_double(benchmark::State& state) {
  double divisor = 1.0000001;
  hide(divisor);
  std::array<double, chains> values;
  values.fill(3.7);
  throughput(state, values, 1, [divisor](double x) { return x / divisor; });
}
BENCHMARK(divide_double);

#if defined(__x86_64__)

/// GCC 12 warns of the undefined lanes of the form without a mask.
__attribute__((target("avx512f"))) __m512i multiply_all(__m512i a, __m512i b) {
  return _mm512_maskz_mul_epi32(0xFF, a, b);
}

// A lambda does not take part in its function's target, so these loops are written out.
#define VECTOR_LIMIT(name, instructions, lanes, Value, start, operand, step)      \
  __attribute__((target(instructions))) void name(benchmark::State& state) {      \
    Value values[chains];                                                         \
    for (Value & value : values) value = start;                                   \
    const Value other = operand;                                                  \
    for (auto _ : state) {                                                        \
      for (int round = 0; round < rounds; ++round) {                              \
        for (Value & value : values) value = step(value, other);                  \
        benchmark::ClobberMemory();                                               \
      }                                                                           \
      benchmark::DoNotOptimize(values[0]);                                        \
    }                                                                             \
    state.SetItemsProcessed(state.iterations() * rounds * int{chains} * (lanes)); \
  }
VECTOR_LIMIT(multiply_avx2, "avx2", 4, __m256i, _mm256_set1_epi64x(0x1234567),
             _mm256_set1_epi64x(0x12345), _mm256_mul_epi32)
VECTOR_LIMIT(multiply_avx512, "avx512f", 8, __m512i, _mm512_set1_epi64(0x1234567),
             _mm512_set1_epi64(0x12345), multiply_all)
VECTOR_LIMIT(divide_double_avx2, "avx2", 4, __m256d, _mm256_set1_pd(3.7), _mm256_set1_pd(1.0000001),
             _mm256_div_pd)
VECTOR_LIMIT(divide_double_avx512, "avx512f", 8, __m512d, _mm512_set1_pd(3.7),
             _mm512_set1_pd(1.0000001), _mm512_div_pd)
#undef VECTOR_LIMIT

const bool registered = [] {
  if (__builtin_cpu_supports("avx2")) {
    benchmark::RegisterBenchmark("multiply_avx2", multiply_avx2);
    benchmark::RegisterBenchmark("divide_double_avx2", divide_double_avx2);
  }
  if (__builtin_cpu_supports("avx512f")) {
    benchmark::RegisterBenchmark("multiply_avx512", multiply_avx512);
    benchmark::RegisterBenchmark("divide_double_avx512", divide_double_avx512);
  }
  return true;
}();

#endif

/// So many bytes read and as many written: in the caches, then in memory.
void copy(benchmark::State& state) {
  const std::vector<unsigned char> from(static_cast<std::size_t>(state.range(0)), 7);
  std::vector<unsigned char> to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * state.range(0));
}
BENCHMARK(copy)->Arg(16 << 10)->Arg(256 << 10)->Arg(8 << 20)->Arg(256 << 20);

}  // namespace
