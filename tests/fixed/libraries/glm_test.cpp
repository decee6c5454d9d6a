/// Tests numbers as components of GLM against plain sums over the type: the same bits.
#define GLM_FORCE_UNRESTRICTED_GENTYPE
#define GLM_FORCE_XYZW_ONLY
#include <glm/ext/matrix_transform.hpp>
#include <glm/glm.hpp>

#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace {

using fixproof::q16_16;

template <class N>
using vec3 = glm::vec<3, N>;
template <class N>
using mat4 = glm::mat<4, 4, N>;

/// What GLM leaves to the program: its own refuse every type that is not IEEE floating point.
template <class N>
N dot(const vec3<N>& a, const vec3<N>& b) {
  const N x[]{a.x, a.y, a.z};
  const N y[]{b.x, b.y, b.z};
  return fixproof::dot(x, y);
}
template <class N>
vec3<N> cross(const vec3<N>& a, const vec3<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
N length(const vec3<N>& v) {
  return fixproof::sqrt(dot(v, v));
}

template <class N>
class GlmComponents : public testing::Test {};
using wrapping = testing::Types<q16_16, fixproof::q8_8, fixproof::q32_32, fixproof::u16_16>;
TYPED_TEST_SUITE(GlmComponents, wrapping);

template <class N, glm::length_t Columns, glm::length_t Rows>
glm::mat<Columns, Rows, N> any_matrix(std::mt19937_64& random) {
  glm::mat<Columns, Rows, N> m;
  for (glm::length_t i = 0; i < Columns; ++i) {
    for (glm::length_t j = 0; j < Rows; ++j) {
      m[i][j] = N::from_raw(static_cast<typename N::raw_type>(random()));
    }
  }
  return m;
}

template <glm::length_t Size, class N>
void expect_product(std::mt19937_64& random) {
  const auto a = any_matrix<N, Size, Size>(random);
  const auto b = any_matrix<N, Size, Size>(random);
  const auto product = a * b;
  const auto vector = a * b[0];
  const auto turned = glm::transpose(a);
  for (glm::length_t column = 0; column < Size; ++column) {
    for (glm::length_t row = 0; row < Size; ++row) {
      N sum;
      for (glm::length_t k = 0; k < Size; ++k) sum += a[k][row] * b[column][k];
      ASSERT_EQ(product[column][row], sum);
      if (column == 0) {
        ASSERT_EQ(vector[row], sum);
      }
      ASSERT_EQ(turned[column][row], a[row][column]);
    }
  }
}

TYPED_TEST(GlmComponents, Products) {
  std::mt19937_64 random(8);
  for (int i = 0; i < 50; ++i) {
    expect_product<2, TypeParam>(random);
    expect_product<3, TypeParam>(random);
    expect_product<4, TypeParam>(random);
  }
}

TYPED_TEST(GlmComponents, Components) {
  std::mt19937_64 random(9);
  const auto m = any_matrix<TypeParam, 2, 3>(random);
  const vec3<TypeParam> a = m[0];
  const vec3<TypeParam> b = m[1];
  for (glm::length_t i = 0; i < 3; ++i) {
    EXPECT_EQ((a + b)[i], a[i] + b[i]);
    EXPECT_EQ((a - b)[i], a[i] - b[i]);
    EXPECT_EQ((a * b)[i], a[i] * b[i]);
    EXPECT_EQ((a / b)[i], a[i] / b[i]);
    EXPECT_EQ((a * TypeParam(2))[i], a[i] * TypeParam(2));
    EXPECT_EQ(glm::lessThan(a, b)[i], a[i] < b[i]);
  }
  EXPECT_TRUE(a == a);
}

TEST(Glm, LengthsOfTheProgramsOwn) {
  const vec3<q16_16> v(q16_16(2), q16_16(3), q16_16(6));
  EXPECT_EQ(dot(v, v), 49);
  EXPECT_EQ(length(v), 7);
  EXPECT_EQ((v / length(v)).z, q16_16(6) / q16_16(7));
  EXPECT_EQ(cross(v, vec3<q16_16>(q16_16(1), q16_16(0), q16_16(0))),
            (vec3<q16_16>(q16_16(0), q16_16(6), q16_16(-3))));
}

TEST(Glm, DeterminantAndInverse) {
  mat4<q16_16> m(q16_16(2));
  m[3][0] = q16_16(-3);
  EXPECT_EQ(glm::determinant(m), 16);
  const mat4<q16_16> inverse = glm::inverse(m);
  EXPECT_EQ(inverse[0][0], q16_16(0.5));
  EXPECT_EQ(inverse[3][0], q16_16(0.75));
  EXPECT_TRUE(m * inverse == mat4<q16_16>(q16_16(1)));
}

TEST(Glm, Moves) {
  const vec3<q16_16> v(q16_16(1), q16_16(2), q16_16(3));
  const mat4<q16_16> identity(q16_16(1));
  const glm::vec<4, q16_16> moved =
      glm::translate(identity, v) * glm::scale(identity, v) * glm::vec<4, q16_16>(v, q16_16(1));
  EXPECT_TRUE(moved == (glm::vec<4, q16_16>(q16_16(2), q16_16(6), q16_16(12), q16_16(1))));
  EXPECT_EQ(glm::mix(v, -v, q16_16(0.75)).z, q16_16(-1.5));
  EXPECT_EQ(glm::vec3(v).y, 2.0F);
}

}  // namespace
