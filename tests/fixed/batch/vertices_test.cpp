/// Tests transforms and project on every path against the operators and the accumulator of the
/// type, with interleaved vertices and with separate coordinate arrays.
#include "tests/fixed/batch/columns.hpp"
#include "tests/fixed/batch/expected.hpp"
#include "tests/fixed/batch/expected_vertex.hpp"
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

/// Vertices or points, both interleaved and as columns.
struct Tuples {
  std::size_t count;
  std::vector<Words> words;
  Column all;
  std::vector<Column> columns;

  /// @param coordinates the words of each column
  Tuples(const Type& type, const std::vector<Words>& coordinates)
      : count(coordinates[0].size()), words(coordinates), all(type, interleaved(coordinates)) {
    for (const Words& column : coordinates) columns.emplace_back(type, column);
  }

 private:
  static Words interleaved(const std::vector<Words>& coordinates) {
    Words all;
    for (std::size_t i = 0; i < coordinates[0].size(); ++i) {
      for (const Words& column : coordinates) all.push_back(column[i]);
    }
    return all;
  }
};

Tuples vertices(const Type& type, std::size_t count) {
  return {type, {operands(type, count, 30), operands(type, count, 31), operands(type, count, 32)}};
}

using From = std::array<const void*, 3>;
using To = std::array<void*, 3>;

/// A transform or a projection of vertices of one type.
struct Operation {
  Type type;
  const char* name;
  /// The numbers of a result.
  std::size_t size;
  /// Computes the expected result. @param by the rows, or the constant
  Fault (*one)(const Words& by, const Word* vertex, Word* result);
  Report (*interleaved)(const void* by, const void* in, void* out, std::size_t count,
                        const Options& how);
  Report (*in_columns)(const void* by, const From& in, const To& out, std::size_t count,
                       const Options& how);

  friend std::ostream& operator<<(std::ostream& out, const Operation& o) {
    return out << o.name << ", " << o.type;
  }
};

/// Operands of an operation, and the results.
class Check {
 public:
  Check(const Operation& operation, const Words& by, const Tuples& in)
      : operation_(operation), by_(operation.type, by), in_(in), want_(expected(by)) {}

  /// @param before the guards in front of the results
  void interleaved(std::size_t before = 1) const {
    for (const auto path : paths()) {
      Column out(operation_.type, in_.count * operation_.size, before);
      Marked marked(in_.count);
      const auto report =
          operation_.interleaved(by_.at(0), in_.all.at(0), out.at(0), in_.count, marked.how(path));
      compare(path, report, marked, {&out}, {&want_.all});
    }
  }
  /// Only for results of the size of a vertex.
  void interleaved_in_place() const {
    for (const auto path : paths()) {
      Column all = in_.all;
      Marked marked(in_.count);
      const auto report =
          operation_.interleaved(by_.at(0), all.at(0), all.at(0), in_.count, marked.how(path));
      compare(path, report, marked, {&all}, {&want_.all});
    }
  }
  /// @param before the guards in front of each column of results
  void in_columns(const std::array<std::size_t, 3>& before) const {
    for (const auto path : paths()) {
      std::vector<Column> in = in_.columns;
      std::vector<Column> out;
      for (const std::size_t guards : before) out.emplace_back(operation_.type, in_.count, guards);
      in_columns(path, in, {&out[0], &out[1], &out[2]});
    }
  }
  /// @param place the column of operands that each column of results replaces
  void columns_in_place(const std::array<std::size_t, 3>& place) const {
    for (const auto path : paths()) {
      std::vector<Column> in = in_.columns;
      in_columns(path, in, {&in[place[0]], &in[place[1]], &in[place[2]]});
    }
  }

 private:
  Tuples expected(const Words& by) {
    std::vector<Words> results(operation_.size, Words(in_.count));
    for (std::size_t i = 0; i < in_.count; ++i) {
      const std::array<Word, 3> vertex{in_.words[0][i], in_.words[1][i], in_.words[2][i]};
      std::array<Word, 3> result{};
      faults_.push_back(operation_.one(by, vertex.data(), result.data()));
      for (std::size_t c = 0; c < operation_.size; ++c) results[c][i] = result[c];
    }
    return {operation_.type, results};
  }

  void in_columns(fixproof::batch::path path, const std::vector<Column>& in,
                  const std::array<Column*, 3>& out) const {
    Marked marked(in_.count);
    const auto report = operation_.in_columns(by_.at(0), {in[0].at(0), in[1].at(0), in[2].at(0)},
                                              {out[0]->at(0), out[1]->at(0), out[2]->at(0)},
                                              in_.count, marked.how(path));
    std::vector<const Column*> want;
    for (const Column& column : want_.columns) want.push_back(&column);
    compare(path, report, marked, {out.begin(), out.end()}, want);
  }

  void compare(fixproof::batch::path path, const Report& report, const Marked& marked,
               const std::vector<const Column*>& got,
               const std::vector<const Column*>& want) const {
    SCOPED_TRACE(testing::Message() << operation_ << ", path " << static_cast<int>(path));
    for (std::size_t c = 0; c < want.size(); ++c) {
      ASSERT_TRUE(same(*got[c], *want[c]))
          << (want.size() == 1 ? "interleaved" : "in column " + std::to_string(c));
    }
    marked.check(report, faults_);
  }

  const Operation& operation_;
  Column by_;
  const Tuples& in_;
  std::vector<Fault> faults_;
  Tuples want_;
};

template <class N>
const Rows<N>& rows_at(const void* by) {
  return *static_cast<const Rows<N>*>(by);
}
template <class N>
Rows<N> rows_of(const Words& by) {
  Rows<N> rows;
  for (std::size_t k = 0; k < 12; ++k) rows[k / 4][k % 4] = number_of<N>(by[k]);
  return rows;
}
template <class N>
Vertex<N> vertex_of(const Word* words) {
  return {number_of<N>(words[0]), number_of<N>(words[1]), number_of<N>(words[2])};
}
template <class N, std::size_t size>
Fault result_of(const Coordinates<N, size>& from, Word* result) {
  for (std::size_t c = 0; c < size; ++c) result[c] = from.values[c].raw();
  return from.fault;
}

/// The two transforms of one type.
struct Transform {
  Operation of_products;
  Operation of_sums;

  friend std::ostream& operator<<(std::ostream& out, const Transform& t) {
    return out << t.of_products.type;
  }
};

/// @param Expected, Call the expected vertex, and the batch
template <class N, auto Expected, auto Call>
Operation transform_of(const char* name) {
  return {Type::of<N>(),
          name,
          3,
          [](const Words& by, const Word* vertex, Word* result) {
            return result_of(Expected(rows_of<N>(by), vertex_of<N>(vertex)), result);
          },
          [](const void* by, const void* in, void* out, std::size_t n, const Options& how) {
            return Call(rows_at<N>(by), numbers<Vertex<N>>(in, n), numbers<Vertex<N>>(out, n), how);
          },
          [](const void* by, const From& in, const To& out, std::size_t n, const Options& how) {
            return Call(rows_at<N>(by), numbers<N>(in[0], n), numbers<N>(in[1], n),
                        numbers<N>(in[2], n), numbers<N>(out[0], n), numbers<N>(out[1], n),
                        numbers<N>(out[2], n), how);
          }};
}

constexpr auto transforms_of = []<class N>(std::type_identity<N> /*number*/) -> Transform {
  constexpr auto product = [](const auto&... with) { return expected_vertex(with...); };
  constexpr auto products = [](const auto&... with) { return fixproof::batch::transform(with...); };
  constexpr auto sum = [](const auto&... with) { return expected_fused_vertex(with...); };
  constexpr auto sums = [](const auto&... with) {
    return fixproof::batch::fused_transform(with...);
  };
  return {transform_of<N, product, products>("transform"),
          transform_of<N, sum, sums>("fused_transform")};
};

void check_layouts(const Operation& transform, const Words& rows, const Tuples& in) {
  if (testing::Test::HasFatalFailure()) return;
  const Check check(transform, rows, in);
  check.interleaved();
  check.interleaved_in_place();
  // Each output has a different alignment relative to the registers.
  check.in_columns({1, 2, 3});
  check.columns_in_place({0, 1, 2});
}

class Transforms : public testing::TestWithParam<Transform> {
 protected:
  [[nodiscard]] static const Operation& of_products() { return GetParam().of_products; }
  [[nodiscard]] static const Operation& of_sums() { return GetParam().of_sums; }
  [[nodiscard]] static const Type& type() { return of_products().type; }
};
INSTANTIATE_TEST_SUITE_P(OfEachType, Transforms,
                         testing::ValuesIn(of_each(fixproof::some_types(), transforms_of)));

TEST_P(Transforms, EveryLayout) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Words rows = operands(type(), 12, seed);
    for (const std::size_t n : lengths()) {
      check_layouts(of_products(), rows, vertices(type(), n));
    }
  }
}

/// Numbers below 1/8 of the range.
Words small_rows(const Type& type, unsigned seed) {
  Words drawn = operands(type, 12, seed);
  for (Word& x : drawn) x /= 8;
  return drawn;
}

TEST_P(Transforms, OfSumsInEveryLayout) {
  std::vector<std::size_t> all = lengths();
  for (std::size_t n = 71; n <= 130; ++n) all.push_back(n);
  for (const unsigned seed : {1U, 2U, 3U}) {
    const Words any = operands(type(), 12, seed);
    const Words small = small_rows(type(), seed);
    for (const std::size_t n : all) {
      const Tuples in = vertices(type(), n);
      check_layouts(of_sums(), any, in);
      check_layouts(of_sums(), small, in);
    }
  }
}

// Sums are below 2^63, or 2^31 in formats of 16 bits, until the magnitudes of a row reach a limit.
TEST_P(Transforms, OfSumsAroundTheLimitOfTheLanes) {
  const Word min = type().lowest();
  const Word max = type().highest();
  std::vector<Words> ends(3);
  for (unsigned signs = 0; signs < 8; ++signs) {
    for (unsigned c = 0; c < 3; ++c) {
      ends[c].insert(ends[c].end(), 3, (signs >> c & 1U) != 0 ? min : max);
    }
  }
  const Tuples in(type(), ends);
  const Words none(4);
  const auto check_rows = [&in](const Words& x, const Words& y, const Words& z) {
    Words rows = x;
    rows.insert(rows.end(), y.begin(), y.end());
    rows.insert(rows.end(), z.begin(), z.end());
    check_layouts(of_sums(), rows, in);
  };
  // Two factors at the lower end use up the range of the lanes; the third one has the rest.
  for (const int rest : {0, 1, 2, 255, 256, 257, 65535, 65536, 65537}) {
    for (const Word translation : {min, max, Word{0}}) {
      const Words up{min, min + rest / 2, -rest % 2, translation};
      const Words down{max, max - rest, 1, translation};
      check_rows(up, down, none);
      check_rows(none, down, up);
      check_rows(none, down, none);
    }
  }
}

/// Checks a batch large enough for non-temporal stores. These start at a multiple of the register
/// size, and a batch whose output aliases an input does not use them.
void check_many(const Operation& transform) {
  const Tuples in = vertices(transform.type, (std::size_t{8} << 20) / 12 + 101);
  const Check check(transform, small_rows(transform.type, 4), in);
  for (const std::size_t before : {1U, 2U, 16U}) {
    check.interleaved(before);
    check.in_columns({before, before, before + 16});
  }
  check.interleaved_in_place();
  check.columns_in_place({1, 2, 0});
}

TEST(ManyVertices, GoPastTheCaches) {
  for (const Transform& both : {transforms_of(std::type_identity<fixproof::q16_16>()),
                                transforms_of(std::type_identity<fixproof::q16_16_saturating>())}) {
    check_many(both.of_products);
    check_many(both.of_sums);
  }
}

constexpr auto projection_of = []<class N>(std::type_identity<N> /*number*/) -> Operation {
  return {Type::of<N>(),
          "project",
          2,
          [](const Words& by, const Word* vertex, Word* result) {
            return result_of(expected_point(vertex_of<N>(vertex), number_of<N>(by[0])), result);
          },
          [](const void* by, const void* in, void* out, std::size_t n, const Options& how) {
            return fixproof::batch::project(numbers<Vertex<N>>(in, n), *static_cast<const N*>(by),
                                            numbers<Point<N>>(out, n), how);
          },
          [](const void* by, const From& in, const To& out, std::size_t n, const Options& how) {
            return fixproof::batch::project(numbers<N>(in[0], n), numbers<N>(in[1], n),
                                            numbers<N>(in[2], n), *static_cast<const N*>(by),
                                            numbers<N>(out[0], n), numbers<N>(out[1], n), how);
          }};
};

class Projections : public testing::TestWithParam<Operation> {};
INSTANTIATE_TEST_SUITE_P(OfEachType, Projections,
                         testing::ValuesIn(of_each(fixproof::dividing_types(), projection_of)));

TEST_P(Projections, EveryLayout) {
  const Type& type = GetParam().type;
  for (const double factor : {-160.0, 0.5, 1.0 / 256}) {
    const auto constant = static_cast<Word>(std::ldexp(factor, type.fraction_bits));
    for (const std::size_t n : lengths()) {
      const Tuples in = vertices(type, n);
      const Check check(GetParam(), {std::clamp(constant, type.lowest(), type.highest())}, in);
      check.interleaved();
      check.in_columns({1, 2, 1});
      check.columns_in_place({2, 0, 1});
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace batch_test
