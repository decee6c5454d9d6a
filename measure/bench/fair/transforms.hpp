/// @file
/// The loops of a transform, for peers and for our side. A Row computes one coordinate:
///
///     using number
///     static constexpr const char* name
///     static number of(const std::array<number, 4>& row, const number& x, y, z)
#pragma once

#include <array>
#include <cstddef>

#include "measure/bench/fair/columns.hpp"

namespace fair {

template <class Row>
struct Columns {
  using in = typename Row::number;
  using out = in;
  static constexpr const char* name = Row::name;
  static void run(const View<in, out>& v, std::size_t count) {
    const auto by = v.rows;
    const in* __restrict a = v.a;
    const in* __restrict b = v.b;
    const in* __restrict c = v.c;
    out* __restrict x = v.x;
    out* __restrict y = v.y;
    out* __restrict z = v.z;
    for (std::size_t i = 0; i < count; ++i) {
      x[i] = Row::of(by[0], a[i], b[i], c[i]);
      y[i] = Row::of(by[1], a[i], b[i], c[i]);
      z[i] = Row::of(by[2], a[i], b[i], c[i]);
    }
  }
};

template <class Row>
struct Interleaved {
  using in = std::array<typename Row::number, 3>;
  using out = in;
  static constexpr const char* name = Row::name;
  static void run(const View<in, out>& v, std::size_t count) {
    const auto by = v.rows;
    const in* __restrict from = v.a;
    out* __restrict to = v.x;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        to[i][k] = Row::of(by[k], from[i][0], from[i][1], from[i][2]);
      }
    }
  }
};

}  // namespace fair
