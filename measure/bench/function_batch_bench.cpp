// Times functions of 16.16 in batches next to those of libmvec, glibc's vector library for double,
// on the same instruction set. `/libmvec` is its call on arrays of double alone; `/libmvec_words`
// adds what words need: conversion to double, and rounding. First checks every result: the type
// must have the bits of its scalar functions, libmvec may be off by one ulp. The counter `off` is
// the share of libmvec's words that are not the nearest.
#include <benchmark/benchmark.h>
#include <immintrin.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "fixed/batch/functions.hpp"
#include "fixed/fixed.hpp"

#define AVX2 __attribute__((target("avx2,fma")))
#define AVX512 __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl")))

// The names that the vector ABI of x86-64 gives them.
extern "C" {
#define LIBMVEC(function)                        \
  __m256d _ZGVdN4v_##function(__m256d) noexcept; \
  __m512d _ZGVeN8v_##function(__m512d) noexcept;
LIBMVEC(exp)
LIBMVEC(exp2)
LIBMVEC(expm1)
LIBMVEC(log)
LIBMVEC(log2)
LIBMVEC(log10)
LIBMVEC(log1p)
LIBMVEC(sinh)
LIBMVEC(cosh)
LIBMVEC(tanh)
LIBMVEC(tan)
LIBMVEC(asin)
LIBMVEC(acos)
LIBMVEC(atan)
LIBMVEC(cbrt)
#undef LIBMVEC
#define LIBMVEC(function)                                  \
  __m256d _ZGVdN4vv_##function(__m256d, __m256d) noexcept; \
  __m512d _ZGVeN8vv_##function(__m512d, __m512d) noexcept;
LIBMVEC(atan2)
LIBMVEC(hypot)
LIBMVEC(pow)
#undef LIBMVEC
}

namespace {

using fixproof::q16_16;
namespace batch = fixproof::batch;

constexpr std::size_t count = 4096;  // all arrays stay in the caches

struct Arrays {
  std::vector<q16_16> x, y, out;
  std::vector<double> real_x, real_y, real_out;
};

struct Range {
  double low, high;
};

struct Contender {
  std::string name;
  Range x, y;
  std::function<void(Arrays&)> run;
  std::function<q16_16(q16_16, q16_16)> scalar;
  bool has_words;   ///< whether run() writes Arrays::out
  bool is_nearest;  ///< whether each word must be the nearest
};

template <auto function>
AVX2 void reals_avx2(Arrays& a) {
  for (std::size_t i = 0; i < count; i += 4) {
    const __m256d x = _mm256_loadu_pd(&a.real_x[i]);
    if constexpr (requires { function(x); }) {
      _mm256_storeu_pd(&a.real_out[i], function(x));
    } else {
      _mm256_storeu_pd(&a.real_out[i], function(x, _mm256_loadu_pd(&a.real_y[i])));
    }
  }
}

template <auto function>
AVX512 void reals_avx512(Arrays& a) {
  for (std::size_t i = 0; i < count; i += 8) {
    const __m512d x = _mm512_loadu_pd(&a.real_x[i]);
    if constexpr (requires { function(x); }) {
      _mm512_storeu_pd(&a.real_out[i], function(x));
    } else {
      _mm512_storeu_pd(&a.real_out[i], function(x, _mm512_loadu_pd(&a.real_y[i])));
    }
  }
}

template <auto function>
AVX2 void words_avx2(Arrays& a) {
  const __m256d unit = _mm256_set1_pd(1.0 / 65536);
  const __m256d scale = _mm256_set1_pd(65536);
  const auto real = [&](const q16_16* from) AVX2 {
    return _mm256_mul_pd(
        _mm256_cvtepi32_pd(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from))), unit);
  };
  for (std::size_t i = 0; i < count; i += 4) {
    const __m256d x = real(&a.x[i]);
    __m256d result;
    if constexpr (requires { function(x); }) {
      result = function(x);
    } else {
      result = function(x, real(&a.y[i]));
    }
    _mm_storeu_si128(reinterpret_cast<__m128i*>(&a.out[i]),
                     _mm256_cvtpd_epi32(_mm256_mul_pd(result, scale)));
  }
}

template <auto function>
AVX512 void words_avx512(Arrays& a) {
  const __m512d unit = _mm512_set1_pd(1.0 / 65536);
  const __m512d scale = _mm512_set1_pd(65536);
  const auto real = [&](const q16_16* from) AVX512 {
    const __m256i words = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
    return _mm512_mul_pd(_mm512_maskz_cvtepi32_pd(0xff, words), unit);
  };
  for (std::size_t i = 0; i < count; i += 8) {
    const __m512d x = real(&a.x[i]);
    __m512d result;
    if constexpr (requires { function(x); }) {
      result = function(x);
    } else {
      result = function(x, real(&a.y[i]));
    }
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(&a.out[i]),
                        _mm512_maskz_cvtpd_epi32(0xff, _mm512_mul_pd(result, scale)));
  }
}

std::vector<Contender> contenders() {
  std::vector<Contender> all;
#define ADD_ALL(function, set, symbol, operands, x_range, y_range, call)                          \
  if (batch::has(batch::path::set)) {                                                             \
    const auto scalar = [](q16_16 x, [[maybe_unused]] q16_16 y) { return fixproof::call; };       \
    const std::string name = std::string(#function) + "/" #set;                                   \
    all.push_back({name + "/q16_16", x_range, y_range,                                            \
                   [](Arrays& a) { batch::function operands; }, scalar, true, true});             \
    all.push_back({name + "/libmvec", x_range, y_range, reals_##set<symbol##_##function>, scalar, \
                   false, false});                                                                \
    all.push_back({name + "/libmvec_words", x_range, y_range, words_##set<symbol##_##function>,   \
                   scalar, true, false});                                                         \
  }
#define ADD(function, ...)                                                                        \
  {                                                                                               \
    constexpr Range range{__VA_ARGS__};                                                           \
    ADD_ALL(function, avx512, _ZGVeN8v, (a.x, a.out, batch::path::avx512), range, range,          \
            function(x))                                                                          \
    ADD_ALL(function, avx2, _ZGVdN4v, (a.x, a.out, batch::path::avx2), range, range, function(x)) \
  }
#define ADD_BINARY(function, x_range, y_range)                                                   \
  ADD_ALL(function, avx512, _ZGVeN8vv, (a.x, a.y, a.out, batch::path::avx512), x_range, y_range, \
          function(x, y))                                                                        \
  ADD_ALL(function, avx2, _ZGVdN4vv, (a.x, a.y, a.out, batch::path::avx2), x_range, y_range,     \
          function(x, y))
  ADD(exp, -10, 10)
  ADD(exp2, -14, 14)
  ADD(expm1, -10, 10)
  ADD(log, 0.001, 30000)
  ADD(log2, 0.001, 30000)
  ADD(log10, 0.001, 30000)
  ADD(log1p, 0.001, 30000)
  ADD(sinh, -10, 10)
  ADD(cosh, -10, 10)
  ADD(tanh, -5, 5)
  ADD(tan, -8, 8)
  ADD(asin, -1, 1)
  ADD(acos, -1, 1)
  ADD(atan, -10, 10)
  ADD(cbrt, -30000, 30000)
  constexpr Range plane{-100, 100};
  constexpr Range base{0.1, 10};
  constexpr Range power{-3, 3};
  ADD_BINARY(atan2, plane, plane)
  ADD_BINARY(hypot, plane, plane)
  ADD_BINARY(pow, base, power)
  return all;
}

Arrays arrays_of(const Contender& one) {
  std::mt19937 random(20);
  Arrays a{.x = {}, .y = {}, .out = {}, .real_x = {}, .real_y = {}, .real_out = {}};
  const auto fill = [&random](const Range& range, std::vector<q16_16>& words,
                              std::vector<double>& reals) {
    std::uniform_real_distribution<double> within(range.low, range.high);
    for (std::size_t i = 0; i < count; ++i) {
      words.push_back(q16_16(within(random)));
      reals.push_back(static_cast<double>(words.back()));
    }
  };
  fill(one.x, a.x, a.real_x);
  fill(one.y, a.y, a.real_y);
  a.out.resize(count);
  a.real_out.resize(count);
  return a;
}

/// The share of words that are not the nearest; ends the program if one is off by more than it may.
double wrong_share(const Contender& one, Arrays& a) {
  if (!one.has_words) return 0;
  one.run(a);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t off =
        std::int64_t{a.out[i].raw()} - std::int64_t{one.scalar(a.x[i], a.y[i]).raw()};
    if (off != 0) ++wrong;
    if (std::abs(off) > (one.is_nearest ? 0 : 1)) {
      std::cerr << one.name << " is off by " << off << " ulps for " << a.x[i] << '\n';
      std::exit(1);
    }
  }
  return static_cast<double>(wrong) / static_cast<double>(count);
}

void time(benchmark::State& state, const Contender& one) {
  Arrays a = arrays_of(one);
  const double off = wrong_share(one, a);
  for (auto _ : state) {
    one.run(a);
    benchmark::ClobberMemory();
  }
  state.counters["off"] = off;
  state.counters["ns"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * count * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  static const std::vector<Contender> all = contenders();
  for (const Contender& one : all) {
    benchmark::RegisterBenchmark(one.name.c_str(),
                                 [&one](benchmark::State& state) { time(state, one); });
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
