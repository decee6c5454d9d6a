/// Tests multiply, multiply-add, divide and square root on every path against the operators of the
/// number type, with every length and alignment.
#include "tests/batch/check.hpp"
#include "tests/batch/expected.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

using fixed::batch::path;

/// Operand arrays of `n` elements, each with a different alignment.
template <class Number>
struct Operands {
  std::vector<Number> all = operands<Number>(3 * 1100, 8);

  [[nodiscard]] std::span<const Number> of(std::size_t which, std::size_t n) const {
    return std::span(all).subspan(1100 * which + n % (which + 5), n);
  }
};

template <class Number>
class Elements : public testing::Test {};
TYPED_TEST_SUITE(Elements, fixed::all_types);

TYPED_TEST(Elements, Multiply) {
  const Operands<TypeParam> drawn;
  for (const std::size_t n : lengths()) {
    const auto a = drawn.of(0, n);
    const auto b = drawn.of(1, n);
    std::vector<Expected<TypeParam>> want;
    for (std::size_t i = 0; i < n; ++i) {
      want.push_back(expected<TypeParam>([](auto x, auto y) { return x * y; }, a[i], b[i]));
    }
    check(want, [&](auto out, auto how) { return fixed::batch::multiply(a, b, out, how); });
  }
}

TYPED_TEST(Elements, Divide) {
  const Operands<TypeParam> drawn;
  for (const std::size_t n : lengths()) {
    const auto a = drawn.of(0, n);
    const auto b = drawn.of(1, n);
    std::vector<Expected<TypeParam>> want;
    for (std::size_t i = 0; i < n; ++i) want.push_back(expected_quotient(a[i], b[i]));
    check(want, [&](auto out, auto how) { return fixed::batch::divide(a, b, out, how); });
  }
}

template <class Number>
class SomeElements : public testing::Test {};
TYPED_TEST_SUITE(SomeElements, fixed::some_types);

TYPED_TEST(SomeElements, MulAdd) {
  const Operands<TypeParam> drawn;
  for (const std::size_t n : lengths()) {
    const auto a = drawn.of(0, n);
    const auto b = drawn.of(1, n);
    const auto c = drawn.of(2, n);
    std::vector<Expected<TypeParam>> want;
    for (std::size_t i = 0; i < n; ++i) {
      want.push_back(expected<TypeParam>(
          [](auto x, auto y, auto z) { return fixed::mul_add(x, y, z); }, a[i], b[i], c[i]));
    }
    check(want, [&](auto out, auto how) { return fixed::batch::mul_add(a, b, c, out, how); });
  }
}

TYPED_TEST(SomeElements, SquareRoot) {
  const Operands<TypeParam> drawn;
  for (const std::size_t n : lengths()) {
    const auto a = drawn.of(0, n);
    std::vector<Expected<TypeParam>> want;
    for (std::size_t i = 0; i < n; ++i) {
      auto one = expected<TypeParam>([](auto x) { return fixed::sqrt(x); }, a[i]);
      if (a[i].raw() < 0) one.fault = Fault::domain_error;
      want.push_back(one);
    }
    check(want, [&](auto out, auto how) { return fixed::batch::sqrt(a, out, how); });
  }
}

// Covers every 8.8 pair in which one operand is near a value where the behaviour changes.
TEST(AllOf88, MultiplyAndDivide) {
  using fixed::q8_8;
  std::vector<q8_8> all;
  for (int raw = -32768; raw <= 32767; raw += 1) {
    all.push_back(q8_8::from_raw(static_cast<std::int16_t>(raw)));
  }
  std::vector<q8_8> out(all.size());
  std::vector<q8_8> other(all.size());
  for (const int raw : {-32768, -32767, -257, -256, -255, -129, -128, -3,  -2,  -1,   0,    1,
                        2,      3,      127,  128,  129,  181,  255,  256, 257, 1000, 32767}) {
    const auto b = q8_8::from_raw(static_cast<std::int16_t>(raw));
    std::fill(other.begin(), other.end(), b);
    for (const path on : paths()) {
      fixed::batch::multiply(all, other, out, {on, {}});
      for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(out[i], all[i] * b);
      fixed::batch::divide(all, other, out, {on, {}});
      for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(out[i], all[i] / b);
      fixed::batch::divide(other, all, out, {on, {}});
      for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(out[i], b / all[i]);
    }
  }
}

}  // namespace
}  // namespace batch_test
