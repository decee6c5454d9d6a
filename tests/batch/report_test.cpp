/// What a batch says beside its results: exceptions, marks, lengths, and outputs that are inputs.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/batch/expected.hpp"

namespace batch_test {
namespace {

using fixed::q16_16;
using fixed::q16_16_i386;
using fixed::q16_16_saturating;
using fixed::q16_16_trapping;
using Report = fixed::batch::report;

template <class Number>
std::vector<Number> numbers(std::initializer_list<double> values) {
  std::vector<Number> all;
  for (const double value : values) all.push_back(Number(value));
  return all;
}

/// The text of the error that `call` throws, or what else it does.
template <class Error, class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  } catch (...) {
    return "another error";
  }
  return "no error";
}

TEST(Reports, CountZeroDivisorsOfATypeThatDoesNotThrow) {
  const auto n = numbers<q16_16>({1, 0, -1, 3});
  const auto d = numbers<q16_16>({0, 0, 0, 2});
  std::vector<q16_16> out(4);
  const Report report = fixed::batch::divide(n, d, out);
  EXPECT_EQ(report, (Report{.divide_errors = 3, .first = 0}));
  EXPECT_FALSE(report.clean());
  using limits = std::numeric_limits<q16_16>;
  EXPECT_EQ(out, (std::vector<q16_16>{limits::max(), q16_16(), limits::lowest(), q16_16(1.5)}));
}

TEST(Reports, CountWhatIsSaturated) {
  const auto a = numbers<q16_16_saturating>({1, 300, 2, -300});
  std::vector<q16_16_saturating> out(4);
  EXPECT_EQ(fixed::batch::multiply(a, numbers<q16_16_saturating>({1, 300, 3, 300}), out),
            (Report{.overflows = 2, .first = 1}));
}

TEST(Reports, AreCleanUnderOverflowThatWraps) {
  const auto a = numbers<q16_16>({300, 300});
  std::vector<q16_16> out(2);
  EXPECT_TRUE(fixed::batch::multiply(a, a, out).clean());
}

TEST(Errors, NameTheFirstElementOnEveryPath) {
  std::vector<q16_16_trapping> a(100, q16_16_trapping(2));
  std::vector<q16_16_trapping> out(100);
  a[37] = a[61] = q16_16_trapping(300);
  for (const auto path : paths()) {
    std::fill(out.begin(), out.end(), q16_16_trapping());
    EXPECT_EQ(error_of<fixed::overflow_error>([&] {
                fixed::batch::multiply(a, a, out, {path, {}});
              }),
              "fixed-point overflow: multiply(element 37, 2 in all)");
    EXPECT_EQ(out[99], q16_16_trapping(4)) << "the batch is finished first";
  }
}

TEST(Errors, AreThoseOfTheType) {
  std::vector<q16_16_i386> n(20, q16_16_i386(7));
  std::vector<q16_16_i386> d(20, q16_16_i386(2));
  d[19] = q16_16_i386();
  for (const auto path : paths()) {
    EXPECT_EQ(error_of<fixed::divide_error>([&] {
                fixed::batch::divide(n, d, n, {path, {}});
              }),
              "fixed-point divide error: divide(element 19, 1 in all)");
    std::fill(n.begin(), n.end(), q16_16_i386(7));
    const auto x = numbers<q16_16_trapping>({4, -1});
    std::vector<q16_16_trapping> out(2);
    EXPECT_EQ(error_of<fixed::domain_error>([&] {
                fixed::batch::sqrt(x, out, {path, {}});
              }),
              "fixed-point domain error: sqrt(element 1, 1 in all)");
  }
}

// Of an overflow and a divide error the earlier one counts, as in a loop over the type.
TEST(Errors, ComeInTheOrderOfTheElements) {
  std::vector<q16_16_trapping> n(40, q16_16_trapping(30000));
  std::vector<q16_16_trapping> d(40, q16_16_trapping(1));
  std::vector<q16_16_trapping> out(40);
  for (const auto path : paths()) {
    d[5] = q16_16_trapping(0.5);
    d[9] = q16_16_trapping();
    EXPECT_EQ(error_of<fixed::overflow_error>([&] {
                fixed::batch::divide(n, d, out, {path, {}});
              }),
              "fixed-point overflow: divide(element 5, 1 in all)");
    std::swap(d[5], d[9]);
    EXPECT_EQ(error_of<fixed::divide_error>([&] {
                fixed::batch::divide(n, d, out, {path, {}});
              }),
              "fixed-point divide error: divide(element 5, 1 in all)");
    d[5] = d[9] = q16_16_trapping(1);
  }
}

TEST(Marks, KeepFromThrowing) {
  const auto n = numbers<q16_16_trapping>({1, 30000, 1});
  const auto d = numbers<q16_16_trapping>({0, 0.5, 1});
  std::array<bool, 3> marks{};
  std::vector<q16_16_trapping> out(3);
  EXPECT_EQ(fixed::batch::divide(n, d, out, {.marks = marks}),
            (Report{.divide_errors = 1, .overflows = 1, .first = 0}));
  EXPECT_EQ(marks, (std::array{true, true, false}));
}

TEST(Lengths, TheShortestCounts) {
  const std::vector<q16_16> a(50, q16_16(2));
  const std::vector<q16_16> b(40, q16_16(3));
  for (const auto path : paths()) {
    std::vector<q16_16> out(45);
    fixed::batch::multiply(a, b, out, {path, {}});
    EXPECT_EQ(out[39], q16_16(6));
    EXPECT_EQ(out[40], q16_16());
    std::array<bool, 20> marks{};
    std::fill(out.begin(), out.end(), q16_16());
    fixed::batch::multiply(a, b, out, {path, marks});
    EXPECT_EQ(out[19], q16_16(6));
    EXPECT_EQ(out[20], q16_16());
  }
}

TEST(Outputs, MayBeInputs) {
  const auto a = operands<q16_16>(100, 1);
  const auto b = operands<q16_16>(100, 2);
  for (const auto path : paths()) {
    const fixed::batch::options how{path, {}};
    auto first = a;
    auto second = b;
    fixed::batch::multiply(first, b, first, how);
    fixed::batch::divide(a, second, second, how);
    auto third = b;
    fixed::batch::mul_add(a, third, third, third, how);
    auto root = a;
    fixed::batch::sqrt(root, root, how);
    for (std::size_t i = 0; i < a.size(); ++i) {
      ASSERT_EQ(first[i], a[i] * b[i]);
      ASSERT_EQ(second[i], a[i] / b[i]);
      ASSERT_EQ(third[i], fixed::mul_add(a[i], b[i], b[i]));
      ASSERT_EQ(root[i], fixed::sqrt(a[i]));
    }
  }
}

// What a path that is not to be had is asked for, the portable one does.
TEST(Paths, ThatAreMissingAreReplaced) {
  const auto a = operands<q16_16>(100, 1);
  for (const auto path : {fixed::batch::path::neon, fixed::batch::path::avx512}) {
    std::vector<q16_16> out(100);
    fixed::batch::multiply(a, a, out, {path, {}});
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(out[i], a[i] * a[i]);
  }
  EXPECT_TRUE(fixed::batch::has(fixed::batch::path::portable));
  EXPECT_TRUE(fixed::batch::has(fixed::batch::best()));
}

}  // namespace
}  // namespace batch_test
