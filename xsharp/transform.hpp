/// @file
/// Vectors, and 3 x 4 transforms: a matrix and a translation.
#pragma once

#include <array>
#include <cstddef>
#include <functional>

namespace xsharp {

template <class N>
struct Vec3 {
  N x{};
  N y{};
  N z{};

  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;

  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
};

/// The dot product; each of the three products is rounded.
template <class N>
constexpr N dot(const Vec3<N>& a, const Vec3<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The cross product, counterclockwise from a to b in a right-handed space.
template <class N>
constexpr Vec3<N> cross(const Vec3<N>& a, const Vec3<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class N>
constexpr Vec3<N> operator*(const Vec3<N>& v, N factor) {
  return {v.x * factor, v.y * factor, v.z * factor};
}

/// A transform in row-major order; the fourth column is the translation. The last row, 0 0 0 1, is
/// implied.
template <class N>
struct Transform {
  std::array<std::array<N, 4>, 3> rows{};

  friend constexpr bool operator==(const Transform&, const Transform&) = default;

  [[nodiscard]] constexpr Vec3<N> row(std::size_t i) const {
    return {rows[i][0], rows[i][1], rows[i][2]};
  }
  /// Sets the matrix part of a row and keeps the translation.
  constexpr void set_row(std::size_t i, const Vec3<N>& v) {
    rows[i][0] = v.x;
    rows[i][1] = v.y;
    rows[i][2] = v.z;
  }
  [[nodiscard]] constexpr Vec3<N> translation() const {
    return {rows[0][3], rows[1][3], rows[2][3]};
  }
};

/// XformVec: rounds each product, then adds them and the translation.
template <class N>
constexpr Vec3<N> apply_products(const Transform<N>& t, const Vec3<N>& v) {
  const auto component = [&v](const std::array<N, 4>& row) {
    return row[0] * v.x + row[1] * v.y + row[2] * v.z + row[3];
  };
  return {component(t.rows[0]), component(t.rows[1]), component(t.rows[2])};
}

/// ConcatXforms: applies `second`, then `first`. Rounds each product. Adds the translation of
/// `first` only in the fourth column, by `add(sum of products, translation)`.
template <class N, class Add = std::plus<N>>
constexpr Transform<N> concatenate_products(const Transform<N>& first, const Transform<N>& second,
                                            const Add& add = {}) {
  Transform<N> result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto& row = first.rows[i];
      result.rows[i][j] =
          row[0] * second.rows[0][j] + row[1] * second.rows[1][j] + row[2] * second.rows[2][j];
    }
    result.rows[i][3] = add(result.rows[i][3], first.rows[i][3]);
  }
  return result;
}

}  // namespace xsharp
