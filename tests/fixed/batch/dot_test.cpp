/// Tests dot products on every path against exact integers.
#include "tests/fixed/batch/expected.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

template <class Number>
class Dots : public testing::Test {};
TYPED_TEST_SUITE(Dots, fixproof::some_types);

template <class Number>
void check(std::span<const Number> a, std::span<const Number> b) {
  exact::integer sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += exact::integer{a[i].raw()} * b[i].raw();
  const auto want = exact::result<Number>({sum, exact::one<Number>});
  for (const auto path : paths()) {
    const auto got = exact::run<Number>([&] { return fixproof::batch::dot(a, b, path); });
    ASSERT_EQ(got, want) << a.size() << " terms, path " << static_cast<int>(path);
  }
}

TYPED_TEST(Dots, AreRoundedOnce) {
  const auto all = operands<TypeParam>(2200, 5);
  for (const std::size_t n : lengths()) {
    check<TypeParam>(std::span(all).subspan(n % 7, n), std::span(all).subspan(1100 + n % 5, n));
  }
}

// At the ends of the range, the sums of the half products come nearest to overflow.
TYPED_TEST(Dots, OfTheEndsOfTheRange) {
  using limits = std::numeric_limits<typename TypeParam::raw_type>;
  for (const auto x : {limits::min(), limits::max()}) {
    for (const auto y : {limits::min(), limits::max()}) {
      for (const std::size_t n : {1U, 2U, 3U, 16U, 31U, 1000U}) {
        const std::vector<TypeParam> a(n, TypeParam::from_raw(x));
        const std::vector<TypeParam> b(n, TypeParam::from_raw(y));
        check<TypeParam>(a, b);
      }
    }
  }
}

}  // namespace
}  // namespace batch_test
