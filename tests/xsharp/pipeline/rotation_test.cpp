/// Tests rotations: direction, loss of orthogonality and its restoration.
#include "xsharp/rotation.hpp"

#include "tests/support/test.hpp"
#include "tests/xsharp/pipeline/draws.hpp"
#include "tests/xsharp/pipeline/matrix.hpp"
#include "tests/xsharp/pipeline/types.hpp"
#include "xsharp/motion.hpp"

namespace xsharp {
namespace {

using draws::Integers;
using pipeline::distance;
using pipeline::matrix_of;
using pipeline::product_error;
using pipeline::triple;
using pipeline::ulp;

constexpr std::array axes{Axis::x, Axis::y, Axis::z};

/// The error bound of a cosine or sine. Table entries are the nearest numbers. The published
/// conversion makes negative values up to 3/2 ulp too high. Double does not round to ulps of 16.16.
template <class N>
double cosine_error(Trigonometry trigonometry, Conversion conversion) {
  if (std::same_as<N, double>) return 1e-15;
  const bool published =
      trigonometry == Trigonometry::floating && conversion == Conversion::published;
  return published ? 1.5 * ulp : 0.5 * ulp;
}

/// The distance that one append_rotation() can add between a matrix and the exact rotation.
///
/// With c and s within e of the exact values and products within p, each entry c * a - s * b of the
/// two new rows is within e * (|a| + |b|) + 2 p. The old rows have length 1, so each new row is
/// within 2 e + 2 p * sqrt 3 as a vector, and both rows together within sqrt 2 times that. An exact
/// rotation preserves the earlier distance, so n steps add up to n times as much. The bound has two
/// per cent more because the rows are no longer exactly of length 1.
template <class N>
double step_error(Trigonometry trigonometry, Conversion conversion) {
  const double e = cosine_error<N>(trigonometry, conversion);
  return 1.02 * std::sqrt(2.0) * (2 * e + 2 * product_error<N>() * std::sqrt(3.0));
}

template <class N>
struct Rotation : testing::Test {};
TYPED_TEST_SUITE(Rotation, pipeline::multiplying_types, );

TYPED_TEST(Rotation, QuarterTurnsAreCounterclockwise) {
  using N = TypeParam;
  // About x, y turns to z; about y, z turns to x; about z, x turns to y.
  for (const auto axis : axes) {
    for (const Trigonometry trigonometry : {Trigonometry::table, Trigonometry::floating}) {
      const auto i = static_cast<std::size_t>(axis);
      Transform<N> t = identity<N>();
      append_rotation(t, axis, turn<N>(900, trigonometry, Conversion::nearest));
      pipeline::Matrix expected{};
      expected[i][i] = 1;
      expected[(i + 2) % 3][(i + 1) % 3] = 1;
      expected[(i + 1) % 3][(i + 2) % 3] = -1;
      EXPECT_LT(distance(matrix_of(t), expected), 1e-15) << "axis " << i;
    }
  }
}

TYPED_TEST(Rotation, LeavesTheTranslation) {
  using N = TypeParam;
  EXPECT_TRUE(draws::hold_for_raws(4, [](const Integers& raw) {
    Transform<N> t = identity<N>();
    for (std::size_t i = 0; i < 3; ++i) {
      t.rows[i][3] = Arithmetic<N>::from_raw(static_cast<std::int32_t>(raw[i]));
    }
    const Vec3<N> before = t.translation();
    for (const Axis axis : axes) {
      append_rotation(t, axis, Arithmetic<N>::turn(static_cast<std::int32_t>(raw[3] % 3600)));
    }
    restore_orthogonality(t);
    return t.translation() == before;
  }));
}

/// Appends rotations by these angles about the axes in turn. @return whether the distance to the
/// exact rotation stays in its bound after each. The distance also bounds the length errors of rows
/// and columns.
template <class N>
bool stays_a_rotation(const Integers& tenths, Trigonometry trigonometry, Conversion conversion) {
  Transform<N> t = identity<N>();
  pipeline::Matrix exact = pipeline::unit_matrix;
  for (std::size_t n = 0; n < tenths.size(); ++n) {
    const std::size_t axis = n * n % 3 + (n % 7 == 0 ? 1 : 0);
    const auto angle = static_cast<std::int32_t>(tenths[n]);
    append_rotation(t, axes[axis], turn<N>(angle, trigonometry, conversion));
    exact = pipeline::product(pipeline::rotation(axis, angle), exact);
    const double allowed = static_cast<double>(n + 1) * step_error<N>(trigonometry, conversion);
    if (distance(matrix_of(t), exact) > allowed) return false;
  }
  return true;
}

TYPED_TEST(Rotation, DistortsNoMoreThanItsRoundings) {
  for (const Trigonometry trigonometry : {Trigonometry::table, Trigonometry::floating}) {
    for (const Conversion conversion : {Conversion::published, Conversion::nearest}) {
      EXPECT_TRUE(draws::hold(60, -32768, 32767, [=](const Integers& tenths) {
        return stays_a_rotation<TypeParam>(tenths, trigonometry, conversion);
      }));
    }
  }
}

TYPED_TEST(Rotation, AFullTurnComesBack) {
  using N = TypeParam;
  for (const Axis axis : axes) {
    for (const std::int32_t steps : {4, 36, 120}) {
      Transform<N> t = identity<N>();
      for (int n = 0; n < steps; ++n) append_rotation(t, axis, Arithmetic<N>::turn(3600 / steps));
      EXPECT_LE(distance(matrix_of(t), pipeline::unit_matrix),
                steps * step_error<N>(Trigonometry::table, Conversion::nearest))
          << steps << " steps about axis " << static_cast<int>(axis);
    }
  }
}

/// The bound of |rows * rows - I| after restore_orthogonality(), if it was at most `skew` <= 0.02
/// before. With products within p:
///
/// - toward_unit() maps length 1 + e to 1 - 3/2 e^2, or |e|^3 / 2 more at most. The dot product is
///   within 3 p, so the factor and each row's length are within 3/2 p + p. The products of the
///   three entries add p * sqrt 3, which makes 4.3 p.
/// - cross() has components within 2 p, so the vector is within 3.5 p. Its length is the product of
///   the rows' lengths, 1 + skew / 2 each, and the sine between them, at least 1 - skew^2 / 1.9. It
///   is within 0.6 skew + 3.5 p of 1.
/// - Every length is therefore within 3/2 (0.6 skew + 8 p)^2 + 4.4 p of 1, and its square within
///   twice that, which is less than 1.2 skew^2 + 9 p.
/// - A cross product is orthogonal to its factors within 3.5 p + 1.8 p, from its own error and that
///   of the last products. The factors of the middle row are the final rows.
template <class N>
double restored_skew(double skew) {
  return 1.2 * skew * skew + 9 * product_error<N>();
}

TYPED_TEST(Rotation, OrthogonalityIsRestored) {
  using N = TypeParam;
  // Each draw has three angles and nine errors of up to 1/300.
  EXPECT_TRUE(draws::hold(12, -218, 218, [](const Integers& drawn) {
    const auto angle = [&](std::size_t i) { return static_cast<std::int32_t>(drawn[i] * 16); };
    const auto exact = pipeline::rotation({angle(0), angle(1), angle(2)});
    Transform<N> t;
    for (std::size_t i = 0; i < 9; ++i) {
      const double error = static_cast<double>(drawn[3 + i]) * ulp;
      t.rows[i / 3][i % 3] = pipeline::number<N>(static_cast<double>(exact[i / 3][i % 3]) + error);
    }
    const double before = pipeline::skew(matrix_of(t));
    const pipeline::Matrix broken = matrix_of(t);
    restore_orthogonality(t);
    // Restoring moves the matrix no farther than the errors it removes.
    return before < 0.02 && pipeline::skew(matrix_of(t)) <= restored_skew<N>(before) &&
           distance(matrix_of(t), exact) < 2 * distance(broken, exact) + 20 * product_error<N>();
  }));
}

// Chapter 52's remedy replaces one row, whose length becomes the product of the others' lengths.
TYPED_TEST(Rotation, OneRowBecomesTheCrossProductOfTheOthers) {
  using N = TypeParam;
  EXPECT_TRUE(draws::hold(9, -70000, 70000, [](const Integers& drawn) {
    Transform<N> t = identity<N>();
    for (std::size_t i = 0; i < 9; ++i) {
      t.rows[i / 3][i % 3] = Arithmetic<N>::from_raw(static_cast<std::int32_t>(drawn[i]));
    }
    t.rows[2][3] = from_whole<N>(7);
    const Transform<N> before = t;
    restore_orthogonality(t, RestoredRows::one);
    const Triple exact = cross(triple(before.row(0)), triple(before.row(1)));
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::fabs(triple(t.row(2))[i] - exact[i]) > 2 * product_error<N>() + 1e-15) return false;
    }
    return t.row(0) == before.row(0) && t.row(1) == before.row(1) &&
           t.translation() == before.translation();
  }));
}

TYPED_TEST(Rotation, RestoredEveryFewTurnsAnObjectKeepsItsShapeForEver) {
  using N = TypeParam;
  ObjectDescription object;
  object.spin.tenths = {30, -27, 41};
  Motion<N> motion(object, {.conversion = Conversion::nearest, .restore_every = 4});
  // Twelve rotations are appended between two restorations.
  const double before =
      2.1 * 12 * step_error<N>(Trigonometry::table, Conversion::nearest) + restored_skew<N>(0);
  for (int frame = 1; frame <= 4000; ++frame) {
    motion.advance();
    const double skew = pipeline::skew(matrix_of(motion.to_world()));
    ASSERT_LE(skew, frame % 4 == 0 ? restored_skew<N>(before) : before) << "frame " << frame;
  }
}

TEST(RotationAfter, IsTheProductOfItsSteps) {
  EXPECT_TRUE(draws::hold(4, -3600, 3600, [](const Integers& drawn) {
    const std::array tenths{static_cast<std::int32_t>(drawn[0]),
                            static_cast<std::int32_t>(drawn[1]),
                            static_cast<std::int32_t>(drawn[2])};
    const std::int64_t steps = std::abs(drawn[3]) % 200;
    const pipeline::Matrix step = pipeline::rotation(tenths);
    pipeline::Matrix exact = pipeline::unit_matrix;
    for (std::int64_t n = 0; n < steps; ++n) exact = pipeline::product(step, exact);
    const auto matrix = rotation_after(tenths, steps);
    pipeline::Matrix found{};
    for (std::size_t i = 0; i < 9; ++i) {
      found[i / 3][i % 3] = static_cast<long double>(matrix[i / 3][i % 3]);
    }
    return distance(found, exact) < 1e-12;
  }));
}

TEST(RotationAfter, NoTurnIsTheIdentity) {
  for (const std::array<std::int32_t, 3> tenths :
       {std::array{0, 0, 0}, std::array{3600, 0, -3600}}) {
    const auto matrix = rotation_after(tenths, 1000000);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(matrix[i][j], i == j ? 1 : 0, 1e-9);
    }
  }
}

TYPED_TEST(Rotation, FromScratchAnObjectNeverLosesItsShape) {
  using N = TypeParam;
  EXPECT_TRUE(draws::hold(3, -3600, 3600, [](const Integers& tenths) {
    ObjectDescription object;
    for (std::size_t i = 0; i < 3; ++i)
      object.spin.tenths[i] = static_cast<std::int32_t>(tenths[i]);
    Motion<N> motion(object, {.from_scratch = true});
    const pipeline::Matrix step = pipeline::rotation(object.spin.tenths);
    pipeline::Matrix exact = pipeline::unit_matrix;
    for (int frame = 0; frame < 300; ++frame) {
      motion.advance();
      exact = pipeline::product(step, exact);
      // Each of the nine entries is within half an ulp.
      if (distance(matrix_of(motion.to_world()), exact) > 1.5 * ulp + 1e-12) return false;
    }
    return true;
  }));
}

}  // namespace
}  // namespace xsharp
