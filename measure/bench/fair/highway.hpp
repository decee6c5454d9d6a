/// @file
/// Loops over the vectors of Highway. Highway chooses the instruction set at run time among those
/// at least as good as the flags of the compiler name, as batches do.
#pragma once

#if defined(FAIR_HIGHWAY)

#include <array>
#include <cstddef>

#include "measure/bench/fair/columns.hpp"
#include "measure/bench/fair/plain.hpp"

namespace fair {

template <class In, class Out = In>
struct Highway : Plain<In, Out> {
  static constexpr const char* name = "Highway";
};

struct HighwayMultiply : Highway<Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayMultiplySaturating : Highway<Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayDivide : Highway<Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayRoot : Highway<Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwaySine : Highway<Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwaySineCosine : Highway<Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayFromDouble : Highway<double, Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayToDouble : Highway<Word, double> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayDot : Highway<Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayTransform : Highway<Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayTransformInterleaved : Highway<std::array<Word, 3>> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayFused : Highway<Word> {
  static void run(const View<in, out>& v, std::size_t count);
};
struct HighwayFusedInterleaved : Highway<std::array<Word, 3>> {
  static void run(const View<in, out>& v, std::size_t count);
};

}  // namespace fair

#endif
