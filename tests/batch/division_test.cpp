/// Tests quotients on every path against the operator of the number type, with every length and
/// alignment, and quotients and roots around the points where their rounding changes, against exact
/// integers in every rounding mode of the processor. One file, so that each divide is compiled
/// once.
#include "tests/batch/check.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/rounding_mode.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

template <class Number>
class Quotients : public testing::Test {};
TYPED_TEST_SUITE(Quotients, fixproof::dividing_types);

TYPED_TEST(Quotients, EveryLength) {
  using N = TypeParam;
  check_every_length<N>([](N a, N b, N) { return expected_quotient(a, b); },
                        [](auto a, auto b, auto, auto out, auto how) {
                          return fixproof::batch::divide(a, b, out, how);
                        });
}

TYPED_TEST(Quotients, AreExactInEveryRoundingMode) {
  std::vector<TypeParam> n;
  std::vector<TypeParam> d;
  std::vector<exact::outcome<TypeParam>> want;
  for (const auto& pair : exact::near_misses<TypeParam>()) {
    n.push_back(pair.n);
    d.push_back(pair.d);
    want.push_back(exact::quotient(pair.n, pair.d));
  }
  const std::size_t count = n.size();
  ASSERT_GT(count, 17'000U);
  std::vector<TypeParam> out(count);
  for (const auto path : paths()) {
    for (const int mode : RoundingMode::all) {
      Marked marked(count);
      const auto how = marked.how(path);
      {
        const RoundingMode set(mode);
        fixproof::batch::divide(n, d, out, how);
      }
      for (std::size_t i = 0; i < count; ++i) {
        if (want[i].throws) {
          ASSERT_TRUE(how.marks[i]) << n[i] << " / " << d[i];
        } else {
          ASSERT_EQ(out[i].raw(), want[i].raw)
              << n[i] << " / " << d[i] << ", path " << static_cast<int>(path) << ", mode " << mode;
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
    for (const int mode : RoundingMode::all) {
      {
        const RoundingMode set(mode);
        fixproof::batch::sqrt(x, out, {path, {}});
      }
      for (std::size_t i = 0; i < x.size(); ++i) {
        ASSERT_EQ(out[i].raw(), want[i]) << x[i] << ", path " << static_cast<int>(path);
      }
    }
  }
}

// The root of r (r + 1) lies nearest to r + 1/2, and the root of a square is exact.
TEST(Roots, AreNearestInEveryRoundingMode) {
  using N = fixproof::q16_16;
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
  using N = fixproof::q8_8;
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
