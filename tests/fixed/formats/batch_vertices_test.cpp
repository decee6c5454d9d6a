/// Tests batches of vertices in every named format against exact integers: transforms and project.
#include "tests/fixed/formats/batch_check.hpp"
#include "tests/fixed/formats/types.hpp"

namespace batch_formats {
namespace {

namespace batch = fixproof::batch;

/// Coordinates, and the fault of their element.
struct ExpectedPoint {
  std::vector<integer> coordinates;
  Fault fault = Fault::none;
};

/// Each product is narrowed, then each sum.
Result coordinate(const Type& type, const integer* row, const integer* vertex) {
  Result sum = product(type, row[0] * vertex[0]);
  const auto add = [&](const Result& term) {
    const Result next = narrowed(type, sum.raw + term.raw, type.rules.range);
    sum = {next.raw, first({sum.fault, term.fault, next.fault})};
  };
  add(product(type, row[1] * vertex[1]));
  add(product(type, row[2] * vertex[2]));
  add({row[3]});
  return sum;
}

/// The exact sum is narrowed once.
Result fused_coordinate(const Type& type, const integer* row, const integer* vertex) {
  return product(type,
                 row[0] * vertex[0] + row[1] * vertex[1] + row[2] * vertex[2] + row[3] * type.one);
}

template <class Coordinate>
ExpectedPoint transformed(const Type& type, const std::vector<integer>& rows, const integer* vertex,
                          const Coordinate& coordinate_of) {
  const Result x = coordinate_of(type, rows.data(), vertex);
  const Result y = coordinate_of(type, rows.data() + 4, vertex);
  const Result z = coordinate_of(type, rows.data() + 8, vertex);
  return {{x.raw, y.raw, z.raw}, first({x.fault, y.fault, z.fault})};
}

ExpectedPoint projected(const Type& type, const integer& constant, const integer* vertex) {
  const Result x = quotient(type, vertex[0], vertex[2]);
  const Result y = quotient(type, vertex[1], vertex[2]);
  const Result to_x = product(type, x.raw * constant);
  const Result to_y = product(type, y.raw * constant);
  const bool error = x.fault == Fault::divide_error || y.fault == Fault::divide_error;
  return {{to_x.raw, to_y.raw},
          error ? Fault::divide_error : first({x.fault, to_x.fault, y.fault, to_y.fault})};
}

/// Compares results in `size` columns with the places.
void compare(std::span<const ExpectedPoint> want, std::span<Column> got, const bool* marks,
             const batch::report& report) {
  batch::report whole;
  for (std::size_t i = 0; i < want.size(); ++i) {
    const Fault fault = want[i].fault;
    for (std::size_t c = 0; c < got.size(); ++c) {
      ASSERT_EQ(got[c][i], want[i].coordinates[c]) << "vertex " << i << ", coordinate " << c;
    }
    ASSERT_EQ(marks[i], fault != Fault::none) << "vertex " << i;
    whole.divide_errors += fault == Fault::divide_error ? 1U : 0U;
    whole.overflows += fault == Fault::overflow ? 1U : 0U;
    if (fault != Fault::none) whole.first = std::min(whole.first, i);
  }
  ASSERT_EQ(report, whole);
}

/// The components of tuples as columns.
template <class N, std::size_t size>
std::vector<Column> columns_of(const std::vector<std::array<N, size>>& tuples) {
  std::vector<Column> columns;
  for (std::size_t c = 0; c < size; ++c) {
    std::vector<integer> values;
    for (const auto& tuple : tuples) values.emplace_back(tuple[c].raw());
    columns.emplace_back(Type::of<N>(), values);
  }
  return columns;
}

integer eighth(const integer& x) { return x / 8; }

constexpr auto vertices = []<class N>() {
  const Type type = Type::of<N>();
  SCOPED_TRACE(testing::Message() << type);
  const auto number = [](const integer& x) {
    return N::from_raw(static_cast<typename N::raw_type>(x));
  };
  for (std::size_t count = 0; count <= 40; ++count) {
    const auto seed = static_cast<unsigned>(10 + count);
    std::vector<integer> by = operands(type, 12, seed);
    // The sums of three products of smaller factors need no more than twice the width of a number.
    if (count % 2 == 0) std::transform(by.begin(), by.end(), by.begin(), eighth);
    std::vector<integer> values = operands(type, 3 * count, seed + 100);
    if (count > 3) values[5] = 0;  // a depth
    std::vector<ExpectedPoint> moved;
    std::vector<ExpectedPoint> fused;
    std::vector<ExpectedPoint> points;
    std::vector<std::array<N, 3>> in(count);
    for (std::size_t i = 0; i < count; ++i) {
      moved.push_back(transformed(type, by, &values[3 * i], coordinate));
      fused.push_back(transformed(type, by, &values[3 * i], fused_coordinate));
      points.push_back(projected(type, by[0], &values[3 * i]));
      for (std::size_t c = 0; c < 3; ++c) in[i][c] = number(values[3 * i + c]);
    }
    std::array<std::array<N, 4>, 3> rows;
    for (std::size_t k = 0; k < 12; ++k) rows[k / 4][k % 4] = number(by[k]);
    const auto marks = std::make_unique<bool[]>(count);
    for (const path use : paths()) {
      const batch::options how{use, {marks.get(), count}};
      // tests/fixed/batch/vertices_test.cpp has every layout, in 16.16 and 8.8.
      std::vector<Column> got = columns_of(in);
      auto report =
          batch::transform(rows, got[0].numbers<N>(), got[1].numbers<N>(), got[2].numbers<N>(),
                           got[0].numbers<N>(), got[1].numbers<N>(), got[2].numbers<N>(), how);
      compare(moved, got, marks.get(), report);
      auto out = in;
      report = batch::fused_transform(rows, out, out, how);
      got = columns_of(out);
      compare(fused, got, marks.get(), report);
      got = columns_of(in);
      report = batch::project(got[0].numbers<N>(), got[1].numbers<N>(), got[2].numbers<N>(),
                              rows[0][0], got[0].numbers<N>(), got[1].numbers<N>(), how);
      compare(points, std::span(got).first(2), marks.get(), report);
      if constexpr (all_combinations) {
        out = in;
        report = batch::transform(rows, out, out, how);
        got = columns_of(out);
        compare(moved, got, marks.get(), report);
        got = columns_of(in);
        report = batch::fused_transform(rows, got[0].numbers<N>(), got[1].numbers<N>(),
                                        got[2].numbers<N>(), got[0].numbers<N>(),
                                        got[1].numbers<N>(), got[2].numbers<N>(), how);
        compare(fused, got, marks.get(), report);
        std::vector<std::array<N, 2>> flat(count);
        report = batch::project(in, rows[0][0], flat, how);
        got = columns_of(flat);
        compare(points, got, marks.get(), report);
      }
      if (testing::Test::HasFailure()) return;
    }
  }
};

constexpr policy products_saturate{.multiply = fixproof::rounding::half_even,
                                   .products = overflow::saturate};
constexpr policy quotients_saturate{.quotients = overflow::saturate};

TEST(BatchesOfVertices, HalfUpWrap) { under<fixproof::policies::wrapping, Turn<0, 2>>(vertices); }
TEST(BatchesOfVertices, HalfEvenSaturate) { under<formats::even_saturate, Turn<1, 2>>(vertices); }
TEST(BatchesOfVertices, CeilingSaturate) { under<formats::ceiling_saturate, Turn<1, 2>>(vertices); }
TEST(BatchesOfVertices, HalfAwayTrap) { under<formats::away_trap, NoTurn, formats_32>(vertices); }
TEST(BatchesOfVertices, SumsTrap) { under<formats::mixed, NoTurn, formats_32>(vertices); }
TEST(BatchesOfVertices, ProductsSaturate) {
  under<products_saturate, NoTurn, formats_32>(vertices);
}
TEST(BatchesOfVertices, SaturateOrFault) { under<saturate_or_fault, NoTurn, formats_16>(vertices); }
TEST(BatchesOfVertices, QuotientsSaturate) {
  under<quotients_saturate, NoTurn, formats_16>(vertices);
}

}  // namespace
}  // namespace batch_formats
