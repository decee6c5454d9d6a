/// Tests numbers as scalars of Eigen against plain loops over the type: the same bits.
#include "fixed/eigen.hpp"

#include <Eigen/Dense>

#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
template <class N>
using Dynamic = Eigen::Matrix<N, Eigen::Dynamic, Eigen::Dynamic>;
template <class N>
using Square3 = Eigen::Matrix<N, 3, 3>;

/// A matrix of any stored integers, or of the numbers from -3 to 3 that `kept` bits distinguish.
template <class Matrix>
void fill(Matrix& m, std::mt19937_64& random, int kept = 0) {
  using N = typename Matrix::Scalar;
  using raw = typename N::raw_type;
  for (Eigen::Index i = 0; i < m.size(); ++i) {
    const std::uint64_t bits = random();
    m.data()[i] =
        kept == 0 ? N::from_raw(static_cast<raw>(bits))
                  : N::from_raw(static_cast<raw>(static_cast<std::int64_t>(bits % (6U << kept)) -
                                                 (std::int64_t{3} << kept)))
                        << (N::fraction_bits - kept);
  }
}

template <class A, class B>
Dynamic<typename A::Scalar> product(const A& a, const B& b) {
  Dynamic<typename A::Scalar> result(a.rows(), b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
      auto sum = a(i, 0) * b(0, j);
      for (Eigen::Index k = 1; k < a.cols(); ++k) sum += a(i, k) * b(k, j);
      result(i, j) = sum;
    }
  }
  return result;
}

template <class N>
class EigenScalars : public testing::Test {};
/// They wrap, so that the order of a sum does not matter.
using wrapping = testing::Types<q16_16, q32_32, u8_8>;
TYPED_TEST_SUITE(EigenScalars, wrapping);

TYPED_TEST(EigenScalars, Products) {
  std::mt19937_64 random(3);
  const auto expect_product = [&](auto a, auto b) {
    fill(a, random);
    fill(b, random);
    EXPECT_EQ(Dynamic<TypeParam>(a * b), product(a, b)) << a.rows() << ' ' << a.cols();
  };
  for (int i = 0; i < 20; ++i) {
    expect_product(Eigen::Matrix<TypeParam, 3, 3>(), Eigen::Matrix<TypeParam, 3, 3>());
    expect_product(Eigen::Matrix<TypeParam, 4, 4>(), Eigen::Matrix<TypeParam, 4, 4>());
    expect_product(Eigen::Matrix<TypeParam, 4, 4>(), Eigen::Matrix<TypeParam, 4, 1>());
    expect_product(Eigen::Matrix<TypeParam, 2, 3>(), Eigen::Matrix<TypeParam, 3, 4>());
  }
  // Beyond 20 rows, columns and terms Eigen takes blocks.
  for (const int size : {1, 5, 21, 70}) {
    expect_product(Dynamic<TypeParam>(size, size + 1), Dynamic<TypeParam>(size + 1, size));
  }
}

TYPED_TEST(EigenScalars, SumsAndElements) {
  using N = TypeParam;
  std::mt19937_64 random(4);
  Eigen::Matrix<N, 3, 4> a;
  Eigen::Matrix<N, Eigen::Dynamic, 1> u(9);
  Eigen::Matrix<N, Eigen::Dynamic, 1> v(9);
  fill(a, random);
  fill(u, random);
  fill(v, random);
  const Eigen::Matrix<N, 4, 3> turned = a.transpose();
  const Eigen::Matrix<N, 3, 4> three = a * N(3);
  const Eigen::Matrix<N, 3, 4> also_three = 3 * a;
  const Eigen::Matrix<N, 3, 4> third = a / 3;
  const Eigen::Matrix<N, 3, 4> difference = three - a;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      EXPECT_EQ(turned(j, i), a(i, j));
      EXPECT_EQ(three(i, j), a(i, j) * N(3));
      EXPECT_EQ(also_three(i, j), 3 * a(i, j));
      EXPECT_EQ(third(i, j), a(i, j) / 3);
      EXPECT_EQ(difference(i, j), three(i, j) - a(i, j));
    }
  }
  N dot = u(0) * v(0);
  N sum = u(0);
  for (int i = 1; i < 9; ++i) {
    dot += u(i) * v(i);
    sum += u(i);
  }
  EXPECT_EQ(u.dot(v), dot);
  EXPECT_EQ(u.sum(), sum);
  EXPECT_EQ(u.maxCoeff(), *std::max_element(u.data(), u.data() + 9));
}

template <class N>
N minor_of(const Square3<N>& m, int i, int j) {
  const int i1 = (i + 1) % 3;
  const int i2 = (i + 2) % 3;
  const int j1 = (j + 1) % 3;
  const int j2 = (j + 2) % 3;
  return m(i1, j1) * m(i2, j2) - m(i1, j2) * m(i2, j1);
}

template <class N>
class EigenInverse : public testing::Test {};
using with_sign = testing::Types<q8_24, q32_32, q16_16_trapping>;
TYPED_TEST_SUITE(EigenInverse, with_sign);

TYPED_TEST(EigenInverse, Of2x2) {
  using N = TypeParam;
  std::mt19937_64 random(5);
  for (int round = 0; round < 200; ++round) {
    Eigen::Matrix<N, 2, 2> m;
    fill(m, random, 2);
    const N determinant = m(0, 0) * m(1, 1) - m(1, 0) * m(0, 1);
    EXPECT_EQ(m.determinant(), determinant);
    if ((abs)(determinant) < N(0.5)) continue;
    const N scale = N(1) / determinant;
    Eigen::Matrix<N, 2, 2> expected;
    expected << m(1, 1) * scale, -m(0, 1) * scale, -m(1, 0) * scale, m(0, 0) * scale;
    EXPECT_EQ(Eigen::Matrix2d(m.inverse().eval().template cast<double>()),
              Eigen::Matrix2d(expected.template cast<double>()));
  }
}

TYPED_TEST(EigenInverse, Of3x3) {
  using N = TypeParam;
  std::mt19937_64 random(6);
  int inverted = 0;
  for (int round = 0; round < 200; ++round) {
    Square3<N> m;
    fill(m, random, 1);
    N determinant = m(0, 0) * minor_of(m, 0, 0);
    for (int i = 1; i < 3; ++i) determinant += m(i, 0) * minor_of(m, i, 0);
    EXPECT_EQ(m.determinant(), determinant);
    if ((abs)(determinant) < N(4)) continue;
    const N scale = N(1) / determinant;
    const Square3<N> inverse = m.inverse();
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) EXPECT_EQ(inverse(i, j), minor_of(m, j, i) * scale);
    }
    // And it is an inverse.
    const Eigen::Matrix3d identity = (m * inverse).eval().template cast<double>();
    EXPECT_TRUE(identity.isApprox(Eigen::Matrix3d::Identity(), 0.002)) << identity;
    ++inverted;
  }
  EXPECT_GT(inverted, 50);
}

TEST(Eigen, InverseOf4x4) {
  Eigen::Matrix<q16_16, 4, 4> m = Eigen::Matrix<q16_16, 4, 4>::Identity() * 2;
  m(0, 3) = q16_16(-3);
  EXPECT_EQ(m.determinant(), 16);
  const Eigen::Matrix<q16_16, 4, 4> inverse = m.inverse();
  EXPECT_EQ(inverse(0, 0), q16_16(0.5));
  EXPECT_EQ(inverse(0, 3), q16_16(0.75));
  EXPECT_EQ(inverse(1, 3), 0);
  EXPECT_EQ((m * inverse).eval(), (Eigen::Matrix<q16_16, 4, 4>::Identity()));
}

TEST(Eigen, Lengths) {
  const Eigen::Matrix<q16_16, 3, 1> v(q16_16(2), q16_16(3), q16_16(6));
  EXPECT_EQ(v.squaredNorm(), 49);
  EXPECT_EQ(v.norm(), 7);
  const Eigen::Matrix<q16_16, 3, 1> unit = v.normalized();
  EXPECT_EQ(unit(2), q16_16(6) / q16_16(7));
  EXPECT_EQ(v.cross(Eigen::Matrix<q16_16, 3, 1>::UnitX()),
            (Eigen::Matrix<q16_16, 3, 1>(q16_16(0), q16_16(6), q16_16(-3))));
  EXPECT_EQ((-v).cwiseAbs().eval(), v);
  EXPECT_EQ(v.array().sqrt()(0), sqrt(q16_16(2)));
  EXPECT_EQ(v.array().sin()(0), sin(q16_16(2)));
}

TEST(Eigen, TurnsAndSolves) {
  using Vector = Eigen::Matrix<q16_16, 3, 1>;
  const Vector x = Vector::UnitX();
  const Eigen::AngleAxis<q16_16> turn(pi_v<q16_16> / 2, Vector::UnitZ());
  const Vector y = turn.toRotationMatrix() * x;
  EXPECT_LE((abs)(y(0)), q16_16(0.0001));
  EXPECT_EQ(y(1), 1);
  Dynamic<q16_16> m(2, 2);
  m << q16_16(4), q16_16(1), q16_16(2), q16_16(3);
  const Eigen::Matrix<q16_16, 2, 1> right(q16_16(9), q16_16(7));
  const Eigen::Matrix<q16_16, 2, 1> solution = m.partialPivLu().solve(right);
  EXPECT_EQ(solution(0), 2);
  EXPECT_EQ(solution(1), 1);
}

template <class N>
constexpr bool traits_hold =
    std::same_as<typename Eigen::NumTraits<N>::Real, N>&& std::same_as<
        typename Eigen::NumTraits<N>::NonInteger, N>&& Eigen::NumTraits<N>::IsSigned ==
        std::numeric_limits<N>::is_signed&& Eigen::NumTraits<N>::IsInteger ==
        (N::fraction_bits == 0) &&
    Eigen::NumTraits<N>::lowest() == std::numeric_limits<N>::lowest() &&
    Eigen::NumTraits<N>::highest() == std::numeric_limits<N>::max() &&
    Eigen::NumTraits<N>::MulCost >= Eigen::NumTraits<N>::AddCost;
static_assert(traits_hold<q16_16> && traits_hold<q8_0> && traits_hold<u16_16> &&
              traits_hold<q2_62>);

TEST(Eigen, ElementsBeginAsZero) {
  EXPECT_EQ(Dynamic<q16_16>(3, 3), (Dynamic<q16_16>::Zero(3, 3)));
  EXPECT_EQ(Square3<q16_16>::Identity().trace(), 3);
}

}  // namespace
