/// @file
/// Appends rotations to a transform, and restores orthogonality.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "xsharp/arithmetic.hpp"

namespace xsharp {

enum class Axis { x, y, z };

/// Cosine and sine from the scene's source.
template <Scalar N>
Turn<N> turn(std::int32_t tenths, Trigonometry trigonometry, Conversion conversion) {
  if (trigonometry == Trigonometry::table) return Arithmetic<N>::turn(tenths);
  const double angle = radians(tenths);
  return {Arithmetic<N>::constant(std::cos(angle), conversion),
          Arithmetic<N>::constant(std::sin(angle), conversion)};
}

/// AppendRotationX, Y, Z: appends a rotation, counterclockwise seen from the positive end of the
/// axis, and keeps the translation. Twelve products.
template <Scalar N>
void append_rotation(Transform<N>& t, Axis axis, const Turn<N>& turn) {
  const std::size_t a = (static_cast<std::size_t>(axis) + 1) % 3;
  const std::size_t b = (static_cast<std::size_t>(axis) + 2) % 3;
  const N minus_sin = -turn.sin;
  for (std::size_t column = 0; column < 3; ++column) {
    const N above = t.rows[a][column];
    const N below = t.rows[b][column];
    t.rows[a][column] = turn.cos * above + minus_sin * below;
    t.rows[b][column] = turn.sin * above + turn.cos * below;
  }
}

/// One Newton step towards unit length for a row of nearly unit length. A length of 1 + e becomes 1
/// - 3/2 e^2, apart from rounding. Does not divide: the divide of the 8088 listing drops the
/// fraction of a length like 0.99998, and faults.
template <Scalar N>
Vec3<N> toward_unit(const Vec3<N>& v) {
  const N factor = (from_whole<N>(3) - dot(v, v)) * Arithmetic<N>::from_raw(0x8000);
  return v * factor;
}

/// Makes the matrix of a transform orthogonal again. Its rows must still be nearly orthogonal and
/// of unit length.
///
/// RestoredRows::one follows chapter 52: the last row becomes the cross product of the other two.
/// The chapter does not say which row. The other two keep the angle between them, and no row is
/// normalised; the length of the new row is the product of the others' lengths, so length errors
/// grow.
///
/// RestoredRows::all is ours: the last row becomes the cross product of the other two, then the
/// middle one that of the last and the first. All are normalised; see toward_unit().
template <Scalar N>
void restore_orthogonality(Transform<N>& t, RestoredRows rows = RestoredRows::all) {
  if (rows == RestoredRows::one) {
    t.set_row(2, cross(t.row(0), t.row(1)));
    return;
  }
  const Vec3<N> first = toward_unit(t.row(0));
  const Vec3<N> last = toward_unit(cross(first, t.row(1)));
  t.set_row(0, first);
  t.set_row(2, last);
  t.set_row(1, toward_unit(cross(last, first)));
}

namespace detail {

struct Quaternion {
  double w = 1;
  double x = 0;
  double y = 0;
  double z = 0;

  friend Quaternion operator*(const Quaternion& a, const Quaternion& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  }
};

}  // namespace detail

/// The matrix of `count` steps of rotations about x, then y, then z, computed in double in closed
/// form: its error does not grow with the number of steps.
inline std::array<std::array<double, 3>, 3> rotation_after(
    const std::array<std::int32_t, 3>& tenths, std::int64_t count) {
  using detail::Quaternion;
  const auto half = [&tenths](std::size_t axis) { return radians(tenths[axis]) / 2; };
  const Quaternion step = Quaternion{std::cos(half(2)), 0, 0, std::sin(half(2))} *
                          Quaternion{std::cos(half(1)), 0, std::sin(half(1)), 0} *
                          Quaternion{std::cos(half(0)), std::sin(half(0)), 0, 0};
  const double sine = std::hypot(step.x, step.y, step.z);
  if (sine == 0) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  // Rotates by a multiple of the step's angle about the step's axis.
  const double angle = static_cast<double>(count) * std::atan2(sine, step.w);
  const double w = std::cos(angle);
  const double scale = std::sin(angle) / sine;
  const double x = step.x * scale;
  const double y = step.y * scale;
  const double z = step.z * scale;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

}  // namespace xsharp
