/// @file
/// Sines and cosines of vectors of double by glibc's libmvec and by SLEEF, in the widest registers
/// that the flags of the compiler name. x86-64 only.
#pragma once

#if defined(FAIR_LIBMVEC) || defined(FAIR_SLEEF)

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "measure/bench/fair/columns.hpp"
#include "measure/bench/fair/plain.hpp"

#if defined(FAIR_SLEEF)
#include <sleef.h>
#endif

// NAME(8) is the function of eight doubles.
#if defined(__AVX512F__)
#define FAIR_LANES 8
#define FAIR_MVEC(function) _ZGVeN8v_##function
#define FAIR_SLEEF_NAME(function) Sleef_##function##d8_u10
#elif defined(__AVX2__)
#define FAIR_LANES 4
#define FAIR_MVEC(function) _ZGVdN4v_##function
#define FAIR_SLEEF_NAME(function) Sleef_##function##d4_u10
#else
#define FAIR_LANES 2
#define FAIR_MVEC(function) _ZGVbN2v_##function
#define FAIR_SLEEF_NAME(function) Sleef_##function##d2_u10
#endif

namespace fair {

using DoubleLanes = double __attribute__((vector_size(FAIR_LANES * 8)));
using WordLanes = std::int32_t __attribute__((vector_size(FAIR_LANES * 4)));
using WideLanes = std::int64_t __attribute__((vector_size(FAIR_LANES * 8)));

extern "C" {
DoubleLanes FAIR_MVEC(sin)(DoubleLanes);
DoubleLanes FAIR_MVEC(cos)(DoubleLanes);
}

inline DoubleLanes angles(const Word* from, std::size_t bytes = sizeof(WordLanes)) {
  WordLanes words{};
  std::memcpy(&words, from, bytes);
  return __builtin_convertvector(words, DoubleLanes) * (1 / 65536.0);
}
/// The sum with 3 * 2^51 has the nearest integer in its low bits.
inline void store(DoubleLanes x, Word* to, std::size_t bytes = sizeof(WordLanes)) {
  const DoubleLanes sum = x * 65536 + 0x1.8p52;
  WideLanes bits;
  std::memcpy(&bits, &sum, sizeof bits);
  const WordLanes words = __builtin_convertvector(bits, WordLanes);
  std::memcpy(to, &words, bytes);
}

template <class Functions>
struct VectorSine : Plain<Word> {
  static constexpr const char* name = Functions::name;
  static void run(const View<in, out>& v, std::size_t count) {
    std::size_t i = 0;
    for (; i + FAIR_LANES <= count; i += FAIR_LANES)
      store(Functions::sin(angles(v.a + i)), v.x + i);
    const std::size_t bytes = (count - i) * sizeof(Word);
    if (bytes != 0) store(Functions::sin(angles(v.a + i, bytes)), v.x + i, bytes);
  }
};
template <class Functions>
struct VectorSineCosine : Plain<Word> {
  static constexpr const char* name = Functions::name;
  static void run(const View<in, out>& v, std::size_t count) {
    std::size_t i = 0;
    for (; i + FAIR_LANES <= count; i += FAIR_LANES) some(v, i, sizeof(WordLanes));
    if (i < count) some(v, i, (count - i) * sizeof(Word));
  }

 private:
  static void some(const View<Word, Word>& v, std::size_t i, std::size_t bytes) {
    DoubleLanes cosines;
    DoubleLanes sines;
    Functions::both(angles(v.a + i, bytes), cosines, sines);
    store(cosines, v.x + i, bytes);
    store(sines, v.y + i, bytes);
  }
};

#if defined(FAIR_LIBMVEC)
struct Mvec {
  static constexpr const char* name = "libmvec";
  static DoubleLanes sin(DoubleLanes x) { return FAIR_MVEC(sin)(x); }
  static void both(DoubleLanes x, DoubleLanes& cosines, DoubleLanes& sines) {
    cosines = FAIR_MVEC(cos)(x);
    sines = FAIR_MVEC(sin)(x);
  }
};
#endif
#if defined(FAIR_SLEEF)
struct Sleef {
  static constexpr const char* name = "SLEEF";
  static DoubleLanes sin(DoubleLanes x) { return FAIR_SLEEF_NAME(sin)(x); }
  static void both(DoubleLanes x, DoubleLanes& cosines, DoubleLanes& sines) {
    const auto result = FAIR_SLEEF_NAME(sincos)(x);
    sines = result.x;
    cosines = result.y;
  }
};
#endif

}  // namespace fair

#endif
