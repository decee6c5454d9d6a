/// Tests transform and project on every path against the operators of the type, with interleaved
/// vertices and with separate coordinate arrays.
#include "tests/batch/check.hpp"
#include "tests/batch/expected.hpp"
#include "tests/batch/expected_vertex.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

/// Whether rows of fixproof::q16_16 can transform a vector of V.
template <class V>
concept transformed_by_q16_16 = requires(const Rows<fixproof::q16_16>& rows, std::vector<V>& v) {
  fixproof::batch::transform(rows, v, v);
};
struct Named {
  fixproof::q16_16 x, y, z;
};
static_assert(transformed_by_q16_16<Vertex<fixproof::q16_16>> && transformed_by_q16_16<Named>);
static_assert(!transformed_by_q16_16<Vertex<float>>);
static_assert(!transformed_by_q16_16<Vertex<fixproof::q16_16_saturating>>);
static_assert(!transformed_by_q16_16<Point<fixproof::q16_16>>);

/// Vertices, both interleaved and as three arrays.
template <class Number>
struct Vertices {
  std::vector<Vertex<Number>> all;
  std::array<std::vector<Number>, 3> columns;

  explicit Vertices(std::size_t count) {
    for (unsigned c = 0; c < 3; ++c) columns[c] = operands<Number>(count, 30 + c);
    for (std::size_t i = 0; i < count; ++i) {
      all.push_back({columns[0][i], columns[1][i], columns[2][i]});
    }
  }
};

/// Interleaves the columns.
template <class Number, std::size_t size>
std::vector<std::array<Number, size>> gathered(
    const std::array<std::vector<Number>, size>& columns) {
  std::vector<std::array<Number, size>> all(columns[0].size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t c = 0; c < size; ++c) all[i][c] = columns[c][i];
  }
  return all;
}

template <class Number>
Rows<Number> rows_of(const std::vector<Number>& drawn) {
  Rows<Number> rows;
  for (std::size_t k = 0; k < 12; ++k) rows[k / 4][k % 4] = drawn[k];
  return rows;
}

template <class Number>
class Transforms : public testing::Test {};
TYPED_TEST_SUITE(Transforms, fixproof::some_types);

TYPED_TEST(Transforms, EveryLayout) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto rows = rows_of(operands<TypeParam>(12, seed));
    for (const std::size_t n : lengths()) {
      const Vertices<TypeParam> v(n);
      std::vector<Coordinates<TypeParam, 3>> want;
      for (const auto& vertex : v.all) want.push_back(expected_vertex(rows, vertex));
      check<TypeParam, 3>(want, [&](auto how) {
        Guarded<Vertex<TypeParam>> out(n);
        const auto report = fixproof::batch::transform(rows, v.all, out.inside(), how);
        EXPECT_TRUE(out.intact());
        return std::pair(report, out.copy());
      });
      check<TypeParam, 3>(want, [&](auto how) {
        auto in_place = v.all;
        const auto report = fixproof::batch::transform(rows, in_place, in_place, how);
        return std::pair(report, in_place);
      });
      check<TypeParam, 3>(want, [&](auto how) {
        // Each output has a different alignment relative to the registers.
        Guarded<TypeParam> to_x(n, 1);
        Guarded<TypeParam> to_y(n, 2);
        Guarded<TypeParam> to_z(n, 3);
        const auto& [x, y, z] = v.columns;
        const auto report = fixproof::batch::transform(rows, x, y, z, to_x.inside(), to_y.inside(),
                                                       to_z.inside(), how);
        EXPECT_TRUE(to_x.intact() && to_y.intact() && to_z.intact());
        return std::pair(report, gathered<TypeParam, 3>({to_x.copy(), to_y.copy(), to_z.copy()}));
      });
      check<TypeParam, 3>(want, [&](auto how) {
        auto columns = v.columns;
        auto& [x, y, z] = columns;
        const auto report = fixproof::batch::transform(rows, x, y, z, x, y, z, how);
        return std::pair(report, gathered<TypeParam, 3>(columns));
      });
    }
  }
}

/// Checks a batch large enough for non-temporal stores. These start at a multiple of the register
/// size, and a batch whose output aliases an input does not use them.
template <class Number>
void check_many() {
  constexpr std::size_t n = (std::size_t{8} << 20) / 12 + 101;
  const auto rows = rows_of(operands<Number>(12, 4));
  const Vertices<Number> v(n);
  std::vector<Coordinates<Number, 3>> want;
  for (const auto& vertex : v.all) want.push_back(expected_vertex(rows, vertex));
  for (const std::size_t before : {1U, 2U, 16U}) {
    check<Number, 3>(want, [&](auto how) {
      Guarded<Vertex<Number>> out(n, before);
      const auto report = fixproof::batch::transform(rows, v.all, out.inside(), how);
      EXPECT_TRUE(out.intact());
      return std::pair(report, out.copy());
    });
    check<Number, 3>(want, [&](auto how) {
      const auto& [x, y, z] = v.columns;
      std::array<Guarded<Number>, 3> to{Guarded<Number>(n, before), Guarded<Number>(n, before),
                                        Guarded<Number>(n, before + 16)};
      const auto report = fixproof::batch::transform(rows, x, y, z, to[0].inside(), to[1].inside(),
                                                     to[2].inside(), how);
      for (const auto& out : to) EXPECT_TRUE(out.intact());
      return std::pair(report, gathered<Number, 3>({to[0].copy(), to[1].copy(), to[2].copy()}));
    });
  }
  check<Number, 3>(want, [&](auto how) {
    auto in_place = v.all;
    const auto report = fixproof::batch::transform(rows, in_place, in_place, how);
    return std::pair(report, in_place);
  });
  check<Number, 3>(want, [&](auto how) {
    auto [x, y, z] = v.columns;
    const auto report = fixproof::batch::transform(rows, x, y, z, y, z, x, how);
    return std::pair(report, gathered<Number, 3>({y, z, x}));
  });
}

TEST(ManyVertices, GoPastTheCaches) {
  check_many<fixproof::q16_16>();
  check_many<fixproof::q16_16_saturating>();
}

template <class Number>
class Projections : public testing::Test {};
TYPED_TEST_SUITE(Projections, fixproof::all_types);

TYPED_TEST(Projections, EveryLayout) {
  for (const double factor : {-160.0, 0.5, 1.0 / 256}) {
    const auto constant =
        TypeParam(fixproof::number<typename TypeParam::raw_type, TypeParam::fraction_bits,
                                   fixproof::policies::saturating>(factor));
    for (const std::size_t n : lengths()) {
      const Vertices<TypeParam> v(n);
      std::vector<Coordinates<TypeParam, 2>> want;
      for (const auto& vertex : v.all) want.push_back(expected_point(vertex, constant));
      check<TypeParam, 2>(want, [&](auto how) {
        Guarded<Point<TypeParam>> out(n);
        const auto report = fixproof::batch::project(v.all, constant, out.inside(), how);
        EXPECT_TRUE(out.intact());
        return std::pair(report, out.copy());
      });
      check<TypeParam, 2>(want, [&](auto how) {
        Guarded<TypeParam> to_x(n, 1);
        Guarded<TypeParam> to_y(n, 2);
        const auto& [x, y, z] = v.columns;
        const auto report =
            fixproof::batch::project(x, y, z, constant, to_x.inside(), to_y.inside(), how);
        EXPECT_TRUE(to_x.intact() && to_y.intact());
        return std::pair(report, gathered<TypeParam, 2>({to_x.copy(), to_y.copy()}));
      });
      check<TypeParam, 2>(want, [&](auto how) {
        auto [x, y, z] = v.columns;
        const auto report = fixproof::batch::project(x, y, z, constant, z, x, how);
        return std::pair(report, gathered<TypeParam, 2>({z, x}));
      });
    }
  }
}

}  // namespace
}  // namespace batch_test
