/// Tests quotients and roots around the points where their rounding changes, against exact integers
/// in every rounding mode of the processor.
#include <fenv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "tests/batch/expected.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/types.hpp"

namespace batch_test {
namespace {

class RoundingMode {
 public:
  explicit RoundingMode(int mode) { EXPECT_EQ(fesetround(mode), 0); }
  RoundingMode(const RoundingMode&) = delete;
  RoundingMode& operator=(const RoundingMode&) = delete;
  ~RoundingMode() { fesetround(FE_TONEAREST); }
};

/// Numerators at, one unit below and one unit above those whose quotient lies nearest to an integer
/// or a half. The signs take every combination. Divisors are edge values, values below 1 and random
/// ones.
template <class Number>
struct Pairs {
  std::vector<Number> n;
  std::vector<Number> d;

  Pairs() {
    std::mt19937_64 random(21);
    for (const Number edge : exact::edges<Number>()) around(edge.raw(), random);
    for (int i = 0; i < 60; ++i) {
      around(static_cast<std::int64_t>(random() % (2 * exact::one<Number>)), random);
      around(static_cast<std::int64_t>(random()) >> (random() % 32 + 32), random);
    }
  }

  void around(std::int64_t divisor, std::mt19937_64& random) {
    using limits = std::numeric_limits<typename Number::raw_type>;
    for (int bits = 1; bits < limits::digits; bits += 3) {
      const auto half_units = static_cast<exact::integer>(random() >> (63 - bits));
      const exact::integer numerator = half_units * divisor / (2 * exact::one<Number>);
      for (const int step : {-1, 0, 1}) {
        for (const int sign : {-1, 1}) add(sign * (numerator + step), divisor);
      }
    }
  }

  void add(exact::integer numerator, exact::integer divisor) {
    using raw = typename Number::raw_type;
    using limits = std::numeric_limits<raw>;
    if (numerator < limits::min() || numerator > limits::max() || divisor < limits::min() ||
        divisor > limits::max()) {
      return;
    }
    n.push_back(Number::from_raw(static_cast<raw>(numerator)));
    d.push_back(Number::from_raw(static_cast<raw>(divisor)));
  }
};

template <class Number>
class Quotients : public testing::Test {};
TYPED_TEST_SUITE(Quotients, fixed::all_types);

TYPED_TEST(Quotients, AreExactInEveryRoundingMode) {
  const Pairs<TypeParam> pairs;
  const std::size_t count = pairs.n.size();
  ASSERT_GT(count, 1000U);
  std::vector<exact::outcome<TypeParam>> want;
  for (std::size_t i = 0; i < count; ++i) {
    want.push_back(exact::quotient(pairs.n[i], pairs.d[i]));
  }
  std::vector<TypeParam> out(count);
  for (const auto path : paths()) {
    for (const int mode : {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
      Marked marked(count);
      const auto how = marked.how(path);
      {
        const RoundingMode set(mode);
        fixed::batch::divide(pairs.n, pairs.d, out, how);
      }
      for (std::size_t i = 0; i < count; ++i) {
        if (want[i].throws) {
          ASSERT_TRUE(how.marks[i]) << pairs.n[i] << " / " << pairs.d[i];
        } else {
          ASSERT_EQ(out[i].raw(), want[i].raw) << pairs.n[i] << " / " << pairs.d[i] << ", path "
                                               << static_cast<int>(path) << ", mode " << mode;
        }
      }
    }
  }
}

/// Checks every path in every rounding mode of the processor. \param want stored integers
template <class N>
void check_roots(const std::vector<N>& x, const std::vector<std::int64_t>& want) {
  std::vector<N> out(x.size());
  for (const auto path : paths()) {
    for (const int mode : {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO}) {
      {
        const RoundingMode set(mode);
        fixed::batch::sqrt(x, out, {path, {}});
      }
      for (std::size_t i = 0; i < x.size(); ++i) {
        ASSERT_EQ(out[i].raw(), want[i]) << x[i] << ", path " << static_cast<int>(path);
      }
    }
  }
}

// The root of r (r + 1) lies nearest to r + 1/2, and the root of a square is exact.
TEST(Roots, AreNearestInEveryRoundingMode) {
  using N = fixed::q16_16;
  std::vector<N> x;
  std::vector<std::int64_t> want;
  std::mt19937_64 random(22);
  while (x.size() < 3000) {
    const auto r = static_cast<std::int64_t>(random() % 11863283);
    // Chooses raw so that raw * 2^16 is near r^2 or r (r + 1).
    for (const std::int64_t target : {r * r, r * (r + 1)}) {
      for (const int step : {0, 1}) {
        const std::int64_t raw = target / 65536 + step;
        if (raw > std::numeric_limits<std::int32_t>::max()) continue;
        x.push_back(N::from_raw(static_cast<std::int32_t>(raw)));
        auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(raw) * 65536)) - 2;
        while ((2 * root + 1) * (2 * root + 1) < 4 * raw * 65536) ++root;
        want.push_back(std::max<std::int64_t>(root, 0));
      }
    }
  }
  check_roots(x, want);
}

TEST(Roots, OfEvery88WordInEveryRoundingMode) {
  using N = fixed::q8_8;
  std::vector<N> x;
  std::vector<std::int64_t> want;
  int root = 0;
  for (int raw = -32768; raw <= 32767; ++raw) {
    x.push_back(N::from_raw(static_cast<std::int16_t>(raw)));
    // Finds the nearest root: the first one whose upper half-way point, squared, exceeds the
    // operand.
    while (raw > 0 && (2 * root + 1) * (2 * root + 1) < 4 * 256 * raw) ++root;
    want.push_back(root);
  }
  check_roots(x, want);
}

}  // namespace
}  // namespace batch_test
