/// Tests the exceptions, marks, length checks and aliased outputs of batches.
#include "fixed/batch/radian.hpp"
#include "tests/fixed/batch/expected.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

using fixproof::q16_16;
using fixproof::q16_16_i386;
using fixproof::q16_16_saturating;
using fixproof::q16_16_trapping;
using Report = fixproof::batch::report;

template <class Number>
std::vector<Number> numbers(std::initializer_list<double> values) {
  std::vector<Number> all;
  for (const double value : values) all.push_back(Number(value));
  return all;
}

template <class Error, class Call>
void expect_error(const std::string& text, const Call& call) {
  try {
    call();
    ADD_FAILURE() << "no error instead of " << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.what(), text);
  }
}

TEST(BatchReports, CountZeroDivisorsOfATypeThatDoesNotThrow) {
  const auto n = numbers<q16_16>({1, 0, -1, 3});
  const auto d = numbers<q16_16>({0, 0, 0, 2});
  std::vector<q16_16> out(4);
  const Report report = fixproof::batch::divide(n, d, out);
  EXPECT_EQ(report, (Report{.divide_errors = 3, .first = 0}));
  EXPECT_FALSE(report.clean());
  using limits = std::numeric_limits<q16_16>;
  EXPECT_EQ(out, (std::vector<q16_16>{limits::max(), q16_16(), limits::lowest(), q16_16(1.5)}));
}

TEST(BatchReports, CountWhatIsSaturated) {
  const auto a = numbers<q16_16_saturating>({1, 300, 2, -300});
  std::vector<q16_16_saturating> out(4);
  EXPECT_EQ(fixproof::batch::multiply(a, numbers<q16_16_saturating>({1, 300, 3, 300}), out),
            (Report{.overflows = 2, .first = 1}));
}

TEST(BatchReports, AreCleanUnderOverflowThatWraps) {
  const auto a = numbers<q16_16>({300, 300});
  std::vector<q16_16> out(2);
  EXPECT_TRUE(fixproof::batch::multiply(a, a, out).clean());
}

TEST(BatchErrors, NameTheFirstElementOnEveryPath) {
  std::vector<q16_16_trapping> a(100, q16_16_trapping(2));
  std::vector<q16_16_trapping> out(100);
  a[37] = a[61] = q16_16_trapping(300);
  for (const auto path : paths()) {
    std::fill(out.begin(), out.end(), q16_16_trapping());
    expect_error<fixproof::overflow_error>("fixed-point overflow: multiply(element 37, 2 in all)",
                                           [&] {
                                             fixproof::batch::multiply(a, a, out, {path, {}});
                                           });
    EXPECT_EQ(out[99], q16_16_trapping(4)) << "the batch is finished first";
  }
}

TEST(BatchErrors, NameTheFirstElementOfMulAdd) {
  using N = q16_16_trapping;
  std::vector<N> a(100, N(2));
  a[37] = a[61] = N(300);
  for (const auto path : paths()) {
    std::vector<N> out(100);
    expect_error<fixproof::overflow_error>("fixed-point overflow: mul_add(element 37, 2 in all)",
                                           [&] {
                                             fixproof::batch::mul_add(a, a, a, out, {path, {}});
                                           });
    EXPECT_EQ(out[99], N(6));
  }
}

TEST(BatchErrors, NameTheFirstVertexOfTransforms) {
  using N = q16_16_trapping;
  std::array<std::array<N, 4>, 3> rows{};
  for (std::size_t i = 0; i < 3; ++i) rows[i][i] = N(200);
  std::vector<std::array<N, 3>> vertices(100, {N(1), N(2), N(3)});
  std::array<std::vector<N>, 3> columns{std::vector<N>(100, N(1)), std::vector<N>(100, N(2)),
                                        std::vector<N>(100, N(3))};
  vertices[37][1] = vertices[61][2] = columns[1][37] = columns[2][61] = N(300);
  const std::string text = "fixed-point overflow: transform(element 37, 2 in all)";
  for (const auto path : paths()) {
    std::vector<std::array<N, 3>> out(100);
    expect_error<fixproof::overflow_error>(text, [&] {
      fixproof::batch::transform(rows, vertices, out, {path, {}});
    });
    EXPECT_EQ(out[99], (std::array{N(200), N(400), N(600)}));
    out.assign(100, {});
    expect_error<fixproof::overflow_error>(
        "fixed-point overflow: fused_transform(element 37, 2 in all)", [&] {
          fixproof::batch::fused_transform(rows, vertices, out, {path, {}});
        });
    EXPECT_EQ(out[99], (std::array{N(200), N(400), N(600)}));
    auto replaced = columns;
    auto& x = replaced[0];
    auto& y = replaced[1];
    auto& z = replaced[2];
    expect_error<fixproof::overflow_error>(text, [&] {
      fixproof::batch::transform(rows, x, y, z, x, y, z, {path, {}});
    });
    EXPECT_EQ((std::array{x[99], y[99], z[99]}), out[99]);
  }
}

TEST(BatchErrors, NameTheFirstVertexOfProject) {
  using N = q16_16_trapping;
  std::vector<std::array<N, 3>> vertices(100, {N(2), N(4), N(2)});
  std::array<std::vector<N>, 3> columns{std::vector<N>(100, N(2)), std::vector<N>(100, N(4)),
                                        std::vector<N>(100, N(2))};
  vertices[37][2] = columns[2][37] = N();
  vertices[61][0] = columns[0][61] = N(30000);  // times 3 / 2 overflows, but in a later element
  const std::string text = "fixed-point divide error: project(element 37, 1 in all)";
  for (const auto path : paths()) {
    std::vector<std::array<N, 2>> out(100);
    expect_error<fixproof::divide_error>(text, [&] {
      fixproof::batch::project(vertices, N(3), out, {path, {}});
    });
    EXPECT_EQ(out[99], (std::array{N(3), N(6)}));
    auto replaced = columns;
    auto& x = replaced[0];
    auto& y = replaced[1];
    const auto& z = replaced[2];
    expect_error<fixproof::divide_error>(text, [&] {
      fixproof::batch::project(x, y, z, N(3), x, y, {path, {}});
    });
    EXPECT_EQ((std::array{x[99], y[99]}), out[99]);
  }
}

TEST(BatchErrors, AreThoseOfTheType) {
  std::vector<q16_16_i386> n(20, q16_16_i386(7));
  std::vector<q16_16_i386> d(20, q16_16_i386(2));
  d[19] = q16_16_i386();
  for (const auto path : paths()) {
    expect_error<fixproof::divide_error>("fixed-point divide error: divide(element 19, 1 in all)",
                                         [&] {
                                           fixproof::batch::divide(n, d, n, {path, {}});
                                         });
    std::fill(n.begin(), n.end(), q16_16_i386(7));
    const auto x = numbers<q16_16_trapping>({4, -1});
    std::vector<q16_16_trapping> out(2);
    expect_error<fixproof::domain_error>("fixed-point domain error: sqrt(element 1, 1 in all)",
                                         [&] {
                                           fixproof::batch::sqrt(x, out, {path, {}});
                                         });
  }
}

// The earlier of an overflow and a divide error counts, as in a loop over the type.
TEST(BatchErrors, ComeInTheOrderOfTheElements) {
  std::vector<q16_16_trapping> n(40, q16_16_trapping(30000));
  std::vector<q16_16_trapping> d(40, q16_16_trapping(1));
  std::vector<q16_16_trapping> out(40);
  for (const auto path : paths()) {
    d[5] = q16_16_trapping(0.5);
    d[9] = q16_16_trapping();
    expect_error<fixproof::overflow_error>("fixed-point overflow: divide(element 5, 1 in all)",
                                           [&] {
                                             fixproof::batch::divide(n, d, out, {path, {}});
                                           });
    std::swap(d[5], d[9]);
    expect_error<fixproof::divide_error>("fixed-point divide error: divide(element 5, 1 in all)",
                                         [&] {
                                           fixproof::batch::divide(n, d, out, {path, {}});
                                         });
    d[5] = d[9] = q16_16_trapping(1);
  }
}

TEST(Marks, KeepFromThrowing) {
  std::vector<q16_16_trapping> n(40, q16_16_trapping(1));
  std::vector<q16_16_trapping> d(40, q16_16_trapping(1));
  d[3] = d[39] = q16_16_trapping();
  n[20] = q16_16_trapping(30000);
  d[20] = q16_16_trapping(0.5);
  std::array<bool, 40> faults{};
  faults[3] = faults[20] = faults[39] = true;
  for (const auto path : paths()) {
    std::array<bool, 40> marks{};
    std::vector<q16_16_trapping> out(40);
    EXPECT_EQ(fixproof::batch::divide(n, d, out, {path, marks}),
              (Report{.divide_errors = 2, .overflows = 1, .first = 3}));
    EXPECT_EQ(marks, faults);
  }
}

TEST(Lengths, TheShortestCounts) {
  const std::vector<q16_16> a(50, q16_16(2));
  const std::vector<q16_16> b(40, q16_16(3));
  for (const auto path : paths()) {
    std::vector<q16_16> out(45);
    fixproof::batch::multiply(a, b, out, {path, {}});
    EXPECT_EQ(out[39], q16_16(6));
    EXPECT_EQ(out[40], q16_16());
    std::array<bool, 20> marks{};
    std::fill(out.begin(), out.end(), q16_16());
    fixproof::batch::multiply(a, b, out, {path, marks});
    EXPECT_EQ(out[19], q16_16(6));
    EXPECT_EQ(out[20], q16_16());
  }
}

/// A container with a signed size, like Qt's.
template <class T>
class SignedSize {
 public:
  explicit SignedSize(std::vector<T> all) : all_(std::move(all)) {}
  [[nodiscard]] T* data() { return all_.data(); }
  [[nodiscard]] const T* data() const { return all_.data(); }
  [[nodiscard]] std::ptrdiff_t size() const { return static_cast<std::ptrdiff_t>(all_.size()); }

 private:
  std::vector<T> all_;
};

TEST(Lengths, MayHaveASign) {
  using N = q16_16;
  const SignedSize<N> a(std::vector<N>(20, N(6)));
  const std::vector<N> b(30, N(2));
  SignedSize<N> out(std::vector<N>(25));
  const auto last = [&out] { return std::pair(out.data()[19], out.data()[20]); };
  fixproof::batch::multiply(a, b, out);
  EXPECT_EQ(last(), std::pair(N(12), N()));
  fixproof::batch::mul_add(a, b, b, out);
  EXPECT_EQ(last(), std::pair(N(14), N()));
  fixproof::batch::divide(a, b, out);
  EXPECT_EQ(last(), std::pair(N(3), N()));
  fixproof::batch::sqrt(b, out);
  EXPECT_EQ(out.data()[24], fixproof::sqrt(N(2)));
  fixproof::batch::sin(a, out);
  std::vector<N> sines(30);
  fixproof::batch::sin_cos(b, sines, out);
  EXPECT_EQ(out.data()[24], fixproof::cos(N(2)));
  EXPECT_EQ(fixproof::batch::dot(a, b), N(240));

  const std::array<std::array<N, 4>, 3> rows{{{N(2)}, {N(), N(2)}, {N(), N(), N(2)}}};
  const SignedSize<std::array<N, 3>> in(std::vector<std::array<N, 3>>(20, {N(4), N(6), N(2)}));
  std::vector<std::array<N, 3>> vertices(30);
  fixproof::batch::transform(rows, in, vertices);
  EXPECT_EQ(vertices[19], (std::array{N(8), N(12), N(4)}));
  EXPECT_EQ(vertices[20], (std::array<N, 3>{}));
  SignedSize<std::array<N, 2>> points(std::vector<std::array<N, 2>>(20));
  fixproof::batch::project(vertices, N(3), points);
  EXPECT_EQ(points.data()[19], (std::array{N(6), N(9)}));
  std::vector<N> x(30);
  std::vector<N> y(30);
  fixproof::batch::transform(rows, a, b, a, x, y, out);
  EXPECT_EQ((std::array{x[19], y[19], out.data()[19], x[20]}),
            (std::array{N(12), N(4), N(12), N()}));
  fixproof::batch::fused_transform(rows, b, a, a, x, y, out);
  EXPECT_EQ((std::array{x[19], y[19], out.data()[19], x[20]}),
            (std::array{N(4), N(12), N(12), N()}));
  fixproof::batch::project(b, a, b, N(3), x, out);
  EXPECT_EQ((std::array{x[19], out.data()[19], x[20]}), (std::array{N(3), N(9), N()}));
}

/// A view whose data() returns a class that converts to a pointer, such as one that is never null.
struct View {
  struct Pointer {
    q16_16* to;
    operator q16_16*() const { return to; }  // NOLINT(*-explicit-conversions): as such classes do
  };
  std::vector<q16_16>& numbers;

  [[nodiscard]] Pointer data() const { return {numbers.data()}; }
  [[nodiscard]] std::size_t size() const { return numbers.size(); }
};

TEST(Ranges, MayHavePointersOfAClass) {
  std::vector x{q16_16(2), q16_16(3)};
  fixproof::batch::multiply(View{x}, View{x}, View{x});
  EXPECT_EQ(x, (std::vector{q16_16(4), q16_16(9)}));
}

TEST(Outputs, MayBeInputs) {
  const auto a = operands<q16_16>(100, 1);
  const auto b = operands<q16_16>(100, 2);
  for (const auto path : paths()) {
    const fixproof::batch::options how{path, {}};
    auto first = a;
    auto second = b;
    fixproof::batch::multiply(first, b, first, how);
    fixproof::batch::divide(a, second, second, how);
    auto third = b;
    fixproof::batch::mul_add(a, third, third, third, how);
    auto root = a;
    fixproof::batch::sqrt(root, root, how);
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(first[i], a[i] * b[i]);
      ASSERT_EQ(second[i], a[i] / b[i]);
      ASSERT_EQ(third[i], fixproof::mul_add(a[i], b[i], b[i]));
      ASSERT_EQ(root[i], fixproof::sqrt(a[i]));
    }
  }
}

// The portable path replaces a path that the processor lacks.
TEST(BatchPaths, ThatAreMissingAreReplaced) {
  const auto a = operands<q16_16>(100, 1);
  for (const auto path : {fixproof::batch::path::neon, fixproof::batch::path::avx512}) {
    std::vector<q16_16> out(100);
    fixproof::batch::multiply(a, a, out, {path, {}});
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(out[i], a[i] * a[i]);
  }
  EXPECT_TRUE(fixproof::batch::has(fixproof::batch::path::portable));
  EXPECT_TRUE(fixproof::batch::has(fixproof::batch::best()));
}

}  // namespace
}  // namespace batch_test
