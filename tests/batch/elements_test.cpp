/// Tests multiply, multiply-add and square root on every path against the operators of the number
/// type, with every length and alignment.
#include "tests/batch/check.hpp"
#include "tests/batch/expected.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

using fixproof::batch::path;

template <class Number>
class Elements : public testing::Test {};
TYPED_TEST_SUITE(Elements, fixproof::some_types);

TYPED_TEST(Elements, Multiply) {
  using N = TypeParam;
  check_every_length<N>(
      [](N a, N b, N) { return expected<N>([](auto x, auto y) { return x * y; }, a, b); },
      [](auto a, auto b, auto, auto out, auto how) {
        return fixproof::batch::multiply(a, b, out, how);
      });
}

TYPED_TEST(Elements, MulAdd) {
  using N = TypeParam;
  check_every_length<N>(
      [](N a, N b, N c) {
        return expected<N>([](auto x, auto y, auto z) { return fixproof::mul_add(x, y, z); }, a, b,
                           c);
      },
      [](auto a, auto b, auto c, auto out, auto how) {
        return fixproof::batch::mul_add(a, b, c, out, how);
      });
}

TYPED_TEST(Elements, SquareRoot) {
  using N = TypeParam;
  check_every_length<N>(
      [](N a, N, N) {
        auto one = expected<N>([](auto x) { return fixproof::sqrt(x); }, a);
        if (a.raw() < 0) one.fault = Fault::domain_error;
        return one;
      },
      [](auto a, auto, auto, auto out, auto how) { return fixproof::batch::sqrt(a, out, how); });
}

// Covers every 8.8 pair in which one operand is near a value where the behaviour changes.
TEST(AllOf88, MultiplyAndDivide) {
  using fixproof::q8_8;
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
      fixproof::batch::multiply(all, other, out, {on, {}});
      for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(out[i], all[i] * b);
      fixproof::batch::divide(all, other, out, {on, {}});
      for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(out[i], all[i] / b);
      fixproof::batch::divide(other, all, out, {on, {}});
      for (std::size_t i = 0; i < all.size(); ++i) ASSERT_EQ(out[i], b / all[i]);
    }
  }
}

}  // namespace
}  // namespace batch_test
