/// @file
/// Peers of dot products and transforms: plain loops and Eigen. And copies, the limit of both.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "measure/bench/fair/columns.hpp"
#include "measure/bench/fair/plain.hpp"
#include "measure/bench/fair/transforms.hpp"

#if defined(FAIR_EIGEN)
#include <Eigen/Core>
#endif
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace fair {

struct IdiomDot : Plain<Word> {
  static constexpr const char* name = "idiom";
  static void run(const View<in, out>& v, std::size_t count) {
    Wide sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += Wide{v.a[i]} * v.b[i];
    v.x[0] = static_cast<Word>((sum + 0x8000) >> 16);
  }
};

using WordRow = std::array<Word, 4>;
struct OfWords {
  using number = Word;
};

/// Rounds each product, as FIXED.ASM and the type do.
struct EachRounded : OfWords {
  static constexpr const char* name = "idiom";
  static Word of(const WordRow& row, Word x, Word y, Word z) {
    return IdiomMultiply::of(row[0], x) + IdiomMultiply::of(row[1], y) +
           IdiomMultiply::of(row[2], z) + row[3];
  }
};
struct SumRounded : OfWords {
  static constexpr const char* name = "idiom, one rounding";
  static Word of(const WordRow& row, Word x, Word y, Word z) {
    const Wide sum = Wide{row[0]} * x + Wide{row[1]} * y + Wide{row[2]} * z;
    return static_cast<Word>((sum + 0x8000) >> 16) + row[3];
  }
};
struct SumInDouble : OfWords {
  static constexpr const char* name = "double";
  static Word of(const WordRow& row, Word x, Word y, Word z) {
    const double sum = static_cast<double>(row[0]) * x + static_cast<double>(row[1]) * y +
                       static_cast<double>(row[2]) * z;
    return nearest(sum * 0x1p-16) + row[3];
  }
};

struct MemcpyColumns : Plain<Word> {
  static constexpr const char* name = "memcpy";
  static void run(const View<in, out>& v, std::size_t count) {
    std::memcpy(v.x, v.a, count * sizeof(Word));
    std::memcpy(v.y, v.b, count * sizeof(Word));
    std::memcpy(v.z, v.c, count * sizeof(Word));
  }
};
#if defined(__SSE2__)
/// Stores past the caches in the widest registers that the flags name.
struct StreamColumns : Plain<Word> {
  static constexpr const char* name = "copy past the caches";
  static void run(const View<in, out>& v, std::size_t count) {
    copy(v.x, v.a, count);
    copy(v.y, v.b, count);
    copy(v.z, v.c, count);
    _mm_sfence();
  }

 private:
  static void copy(Word* to, const Word* from, std::size_t count) {
#if defined(__AVX512F__)
    using Lanes = __m512i;
    const auto store = [](void* at, Lanes x) { _mm512_stream_si512(static_cast<Lanes*>(at), x); };
#elif defined(__AVX2__)
    using Lanes = __m256i;
    const auto store = [](void* at, Lanes x) { _mm256_stream_si256(static_cast<Lanes*>(at), x); };
#else
    using Lanes = __m128i;
    const auto store = [](void* at, Lanes x) { _mm_stream_si128(static_cast<Lanes*>(at), x); };
#endif
    constexpr std::size_t lanes = sizeof(Lanes) / sizeof(Word);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
      Lanes x;
      std::memcpy(&x, from + i, sizeof x);
      store(to + i, x);
    }
    for (; i < count; ++i) to[i] = from[i];
  }
};
#endif

#if defined(FAIR_EIGEN)
using EigenWords = Eigen::Map<const Eigen::Array<Word, Eigen::Dynamic, 1>>;
using EigenResults = Eigen::Map<Eigen::Array<Word, Eigen::Dynamic, 1>>;

inline auto doubles(const Word* from, std::size_t count) {
  return EigenWords(from, static_cast<Eigen::Index>(count)).cast<double>();
}

struct EigenDot : Plain<Word> {
  static constexpr const char* name = "Eigen, double";
  static void run(const View<in, out>& v, std::size_t count) {
    const double sum = doubles(v.a, count).matrix().dot(doubles(v.b, count).matrix());
    v.x[0] = nearest(sum * 0x1p-16);
  }
};
struct EigenColumns : Plain<Word> {
  static constexpr const char* name = "Eigen, double";
  static void run(const View<in, out>& v, std::size_t count) {
    const auto x = doubles(v.a, count);
    const auto y = doubles(v.b, count);
    const auto z = doubles(v.c, count);
    const std::array<Word*, 3> to{v.x, v.y, v.z};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t j) { return v.rows[k][j] * 0x1p-16; };
      EigenResults(to[k], static_cast<Eigen::Index>(count)) =
          (x * at(0) + y * at(1) + z * at(2) + v.rows[k][3]).rint().template cast<Word>();
    }
  }
};

/// Arrays of floating-point numbers: nothing is converted or rounded to 16.16.
template <class Number>
struct EigenVertices : Plain<std::array<Number, 3>> {
  static constexpr const char* name = "Eigen, float arrays";
  using Matrix = Eigen::Matrix<Number, 3, Eigen::Dynamic>;
  static void run(const View<std::array<Number, 3>, std::array<Number, 3>>& v, std::size_t count) {
    Eigen::Matrix<Number, 3, 3> turn;
    Eigen::Matrix<Number, 3, 1> move;
    for (int k = 0; k < 3; ++k) {
      const auto& row = v.rows[static_cast<std::size_t>(k)];
      turn.row(k) << row[0], row[1], row[2];
      move[k] = row[3];
    }
    const Eigen::Map<const Matrix> from(v.a->data(), 3, static_cast<Eigen::Index>(count));
    Eigen::Map<Matrix> to(v.x->data(), 3, static_cast<Eigen::Index>(count));
    to.noalias() = turn * from;
    to.colwise() += move;
  }
};
#endif

}  // namespace fair
