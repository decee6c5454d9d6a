/// Tests transforms and project on every path against the operators and the accumulator of the
/// type, with interleaved vertices and with separate coordinate arrays.
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
/// Like vectors of GLM: its constructor converts what it is given.
template <class Number>
struct Converting {
  Converting() = default;
  template <class A, class B, class C>
  Converting(A a, B b, C c)
      : x(static_cast<Number>(a)), y(static_cast<Number>(b)), z(static_cast<Number>(c)) {}
  Number x, y, z;
};
struct Fixed {
  const fixproof::q16_16 x, y, z;
};
static_assert(transformed_by_q16_16<Vertex<fixproof::q16_16>> && transformed_by_q16_16<Named> &&
              transformed_by_q16_16<Converting<fixproof::q16_16>>);
static_assert(!transformed_by_q16_16<Converting<float>> && !transformed_by_q16_16<Fixed> &&
              !transformed_by_q16_16<Converting<fixproof::number<std::int32_t, 24>>>);
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

/// The two transforms.
struct EachProduct {
  template <class Number>
  static Coordinates<Number, 3> expected(const Rows<Number>& rows, const Vertex<Number>& v) {
    return expected_vertex(rows, v);
  }
  template <class... Arguments>
  static fixproof::batch::report call(Arguments&&... arguments) {
    return fixproof::batch::transform(std::forward<Arguments>(arguments)...);
  }
};
struct EachSum {
  template <class Number>
  static Coordinates<Number, 3> expected(const Rows<Number>& rows, const Vertex<Number>& v) {
    return expected_fused_vertex(rows, v);
  }
  template <class... Arguments>
  static fixproof::batch::report call(Arguments&&... arguments) {
    return fixproof::batch::fused_transform(std::forward<Arguments>(arguments)...);
  }
};

template <class Transform, class Number>
std::vector<Coordinates<Number, 3>> expected_of(const Rows<Number>& rows,
                                                const Vertices<Number>& v) {
  std::vector<Coordinates<Number, 3>> want;
  for (const auto& vertex : v.all) want.push_back(Transform::expected(rows, vertex));
  return want;
}

template <class Transform, class Number>
void check_layouts(const Rows<Number>& rows, const Vertices<Number>& v) {
  const std::size_t n = v.all.size();
  const auto want = expected_of<Transform>(rows, v);
  check<Number, 3>(want, [&](auto how) {
    Guarded<Vertex<Number>> out(n);
    const auto report = Transform::call(rows, v.all, out.inside(), how);
    EXPECT_TRUE(out.intact());
    return std::pair(report, out.copy());
  });
  check<Number, 3>(want, [&](auto how) {
    auto in_place = v.all;
    const auto report = Transform::call(rows, in_place, in_place, how);
    return std::pair(report, in_place);
  });
  check<Number, 3>(want, [&](auto how) {
    // Each output has a different alignment relative to the registers.
    Guarded<Number> to_x(n, 1);
    Guarded<Number> to_y(n, 2);
    Guarded<Number> to_z(n, 3);
    const auto& [x, y, z] = v.columns;
    const auto report =
        Transform::call(rows, x, y, z, to_x.inside(), to_y.inside(), to_z.inside(), how);
    EXPECT_TRUE(to_x.intact() && to_y.intact() && to_z.intact());
    return std::pair(report, gathered<Number, 3>({to_x.copy(), to_y.copy(), to_z.copy()}));
  });
  check<Number, 3>(want, [&](auto how) {
    auto columns = v.columns;
    auto& [x, y, z] = columns;
    const auto report = Transform::call(rows, x, y, z, x, y, z, how);
    return std::pair(report, gathered<Number, 3>(columns));
  });
}

template <class Number>
class Transforms : public testing::Test {};
TYPED_TEST_SUITE(Transforms, fixproof::some_types);

TYPED_TEST(Transforms, EveryLayout) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto rows = rows_of(operands<TypeParam>(12, seed));
    for (const std::size_t n : lengths()) {
      check_layouts<EachProduct>(rows, Vertices<TypeParam>(n));
    }
  }
}

/// Numbers below 1/8 of the range.
template <class Number>
Rows<Number> small_rows(unsigned seed) {
  auto drawn = operands<Number>(12, seed);
  for (Number& x : drawn) x = Number::from_raw(static_cast<typename Number::raw_type>(x.raw() / 8));
  return rows_of(drawn);
}

TYPED_TEST(Transforms, OfSumsInEveryLayout) {
  std::vector<std::size_t> all = lengths();
  for (std::size_t n = 71; n <= 130; ++n) all.push_back(n);
  for (const unsigned seed : {1U, 2U, 3U}) {
    const auto any = rows_of(operands<TypeParam>(12, seed));
    const auto small = small_rows<TypeParam>(seed);
    for (const std::size_t n : all) {
      check_layouts<EachSum>(any, Vertices<TypeParam>(n));
      check_layouts<EachSum>(small, Vertices<TypeParam>(n));
    }
  }
}

// Sums are below 2^63, or 2^31 in formats of 16 bits, until the magnitudes of a row reach a limit.
TYPED_TEST(Transforms, OfSumsAroundTheLimitOfTheLanes) {
  using raw = typename TypeParam::raw_type;
  using limits = std::numeric_limits<raw>;
  const auto number = [](auto x) { return TypeParam::from_raw(static_cast<raw>(x)); };
  std::vector<Vertex<TypeParam>> ends;
  for (unsigned signs = 0; signs < 8; ++signs) {
    Vertex<TypeParam> v;
    for (unsigned c = 0; c < 3; ++c) {
      v[c] = number((signs >> c & 1U) != 0 ? limits::min() : limits::max());
    }
    ends.insert(ends.end(), 3, v);
  }
  Vertices<TypeParam> v(ends.size());
  v.all = ends;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) v.columns[c][i] = ends[i][c];
  }
  const std::array<TypeParam, 4> none{};
  // Two factors at the lower end use up the range of the lanes; the third one has the rest.
  for (const int rest : {0, 1, 2, 255, 256, 257, 65535, 65536, 65537}) {
    for (const auto translation : {limits::min(), limits::max(), raw{0}}) {
      const std::array<TypeParam, 4> up{number(limits::min()), number(limits::min() + rest / 2),
                                        number(-rest % 2), number(translation)};
      const std::array<TypeParam, 4> down{number(limits::max()), number(limits::max() - rest),
                                          number(1), number(translation)};
      check_layouts<EachSum>(Rows<TypeParam>{up, down, none}, v);
      check_layouts<EachSum>(Rows<TypeParam>{none, down, up}, v);
      check_layouts<EachSum>(Rows<TypeParam>{none, down, none}, v);
    }
  }
}

/// Checks a batch large enough for non-temporal stores. These start at a multiple of the register
/// size, and a batch whose output aliases an input does not use them.
template <class Transform, class Number>
void check_many() {
  constexpr std::size_t n = (std::size_t{8} << 20) / 12 + 101;
  const auto rows = small_rows<Number>(4);
  const Vertices<Number> v(n);
  const auto want = expected_of<Transform>(rows, v);
  for (const std::size_t before : {1U, 2U, 16U}) {
    check<Number, 3>(want, [&](auto how) {
      Guarded<Vertex<Number>> out(n, before);
      const auto report = Transform::call(rows, v.all, out.inside(), how);
      EXPECT_TRUE(out.intact());
      return std::pair(report, out.copy());
    });
    check<Number, 3>(want, [&](auto how) {
      const auto& [x, y, z] = v.columns;
      std::array<Guarded<Number>, 3> to{Guarded<Number>(n, before), Guarded<Number>(n, before),
                                        Guarded<Number>(n, before + 16)};
      const auto report =
          Transform::call(rows, x, y, z, to[0].inside(), to[1].inside(), to[2].inside(), how);
      for (const auto& out : to) EXPECT_TRUE(out.intact());
      return std::pair(report, gathered<Number, 3>({to[0].copy(), to[1].copy(), to[2].copy()}));
    });
  }
  check<Number, 3>(want, [&](auto how) {
    auto in_place = v.all;
    const auto report = Transform::call(rows, in_place, in_place, how);
    return std::pair(report, in_place);
  });
  check<Number, 3>(want, [&](auto how) {
    auto [x, y, z] = v.columns;
    const auto report = Transform::call(rows, x, y, z, y, z, x, how);
    return std::pair(report, gathered<Number, 3>({y, z, x}));
  });
}

TEST(ManyVertices, GoPastTheCaches) {
  check_many<EachProduct, fixproof::q16_16>();
  check_many<EachProduct, fixproof::q16_16_saturating>();
  check_many<EachSum, fixproof::q16_16>();
  check_many<EachSum, fixproof::q16_16_saturating>();
}

template <class Number>
class Projections : public testing::Test {};
TYPED_TEST_SUITE(Projections, fixproof::dividing_types);

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
