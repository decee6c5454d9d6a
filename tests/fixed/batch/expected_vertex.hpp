/// @file
/// Expected results of transforming or projecting one vertex, from the number type.
#pragma once

#include <array>
#include <cstddef>

#include "tests/fixed/batch/expected.hpp"

namespace batch_test {

template <class Number>
using Vertex = std::array<Number, 3>;
template <class Number>
using Point = std::array<Number, 2>;
template <class Number>
using Rows = std::array<std::array<Number, 4>, 3>;

template <class Number, std::size_t size>
struct Coordinates {
  std::array<Number, size> values;
  Fault fault = Fault::none;
};

/// @param coordinate (row[0], row[1], row[2], row[3], x, y, z), in numbers of one type
template <class Number, class Coordinate>
Coordinates<Number, 3> expected_vertex(const Rows<Number>& rows, const Vertex<Number>& v,
                                       const Coordinate& coordinate) {
  Coordinates<Number, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = rows[i];
    const auto one = expected<Number>(coordinate, row[0], row[1], row[2], row[3], v[0], v[1], v[2]);
    result.values[i] = one.value;
    if (result.fault == Fault::none) result.fault = one.fault;
  }
  return result;
}

/// Each product is rounded.
template <class Number>
Coordinates<Number, 3> expected_vertex(const Rows<Number>& rows, const Vertex<Number>& v) {
  return expected_vertex(rows, v, [](auto a, auto b, auto c, auto t, auto x, auto y, auto z) {
    return a * x + b * y + c * z + t;
  });
}

/// Each sum is rounded.
template <class Number>
Coordinates<Number, 3> expected_fused_vertex(const Rows<Number>& rows, const Vertex<Number>& v) {
  return expected_vertex(rows, v, [](auto a, auto b, auto c, auto t, auto x, auto y, auto z) {
    fixproof::accumulator<decltype(a)> sum;
    return sum.add_product(a, x).add_product(b, y).add_product(c, z).add(t).result();
  });
}

template <class Number>
Coordinates<Number, 2> expected_point(const Vertex<Number>& v, Number constant) {
  const auto times = [](auto a, auto b) { return a * b; };
  const auto x = expected_quotient(v[0], v[2]);
  const auto y = expected_quotient(v[1], v[2]);
  const auto to_x = expected<Number>(times, x.value, constant);
  const auto to_y = expected<Number>(times, y.value, constant);
  const bool error = x.fault == Fault::divide_error || y.fault == Fault::divide_error;
  return {{to_x.value, to_y.value},
          error ? Fault::divide_error : first_fault<Number>({x, y, to_x, to_y})};
}

}  // namespace batch_test
