/// @file
/// Reference rotations in long double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "xsharp/transform.hpp"

namespace pipeline {

using Matrix = std::array<std::array<long double, 3>, 3>;

inline constexpr Matrix unit_matrix{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
    }
  }
  return result;
}

/// A counterclockwise rotation about x (0), y (1) or z (2), seen from the end of the axis.
inline Matrix rotation(std::size_t axis, std::int32_t tenths) {
  const long double angle = tenths * std::numbers::pi_v<long double> / 1800;
  const long double c = std::cos(angle);
  const long double s = std::sin(angle);
  if (axis == 0) return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
  if (axis == 1) return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
  return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

/// Rotates about x, then y, then z.
inline Matrix rotation(const std::array<std::int32_t, 3>& tenths) {
  return product(rotation(2, tenths[2]), product(rotation(1, tenths[1]), rotation(0, tenths[0])));
}

template <class N>
Matrix matrix_of(const xsharp::Transform<N>& t) {
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[i][j] = static_cast<long double>(static_cast<double>(t.rows[i][j]));
    }
  }
  return result;
}

/// The Frobenius norm of the difference.
inline double distance(const Matrix& a, const Matrix& b) {
  long double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += (a[i][j] - b[i][j]) * (a[i][j] - b[i][j]);
  }
  return static_cast<double>(std::sqrt(sum));
}

inline double skew(const Matrix& m) {
  long double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      long double dot = i == j ? -1 : 0;
      for (std::size_t k = 0; k < 3; ++k) dot += m[i][k] * m[j][k];
      worst = std::max(worst, std::fabs(dot));
    }
  }
  return static_cast<double>(worst);
}

}  // namespace pipeline
