// Tests that shrinking makes failing cases as simple as possible and that they still fail.
#include "verify/shrink.hpp"

#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"

namespace fixproof {
namespace shrink_test {

using Words = std::vector<std::uint32_t>;
using Said = std::pair<std::string, std::string>;
using View = std::span<const std::uint32_t>;

TEST(Shrink, ComesToZeroWhenEverythingFails) {
  EXPECT_EQ(verify::shrink({0x12345678, 0xdeadbeef, 1}, 32, [](View) { return true; }),
            (Words{0, 0, 0}));
}

TEST(Shrink, KeepsACaseThatNothingSimplerShares) {
  const Words only{0x12345678, 0x9abcdef0};
  EXPECT_EQ(verify::shrink(only, 32, [&](View w) { return Words(w.begin(), w.end()) == only; }),
            only);
}

TEST(Shrink, FindsTheBitsThatMatter) {
  EXPECT_EQ(verify::shrink({0x7eadbeef, 0x5555}, 32, [](View w) { return (w[0] & 0x20U) != 0; }),
            (Words{0x20, 0}));
  EXPECT_EQ(verify::shrink({0xdeadbeef}, 32, [](View w) { return w[0] >> 31U != 0; }),
            (Words{0xffffffff}));
  EXPECT_EQ(verify::shrink({0xdead}, 16, [](View w) { return w[0] >> 15U != 0; }), (Words{0xffff}));
  EXPECT_EQ(verify::shrink({0xdeadbeef}, 32, [](View w) { return w[0] != 0; }), (Words{1}));
  // At least 1.5.
  EXPECT_EQ(
      verify::shrink({0x00038765}, 32, [](View w) { return w[0] >= 0x18000 && w[0] >> 31U == 0; }),
      (Words{0x20000}));
}

TEST(Shrink, ATieOfFullWidthBecomesTwoPowersOfTwo) {
  const auto tie = [](View w) {
    const auto product =
        std::int64_t{static_cast<std::int32_t>(w[0])} * static_cast<std::int32_t>(w[1]);
    return (product & 0xffff) == 0x8000 && product < 0;
  };
  const Words from{0xfedcba20, 0x12345400};
  ASSERT_TRUE(tie(from));
  const Words to = verify::shrink(from, 32, tie);
  EXPECT_TRUE(tie(to));
  EXPECT_EQ(to, (Words{0xffffffe0, 0x400}));
}

TEST(Shrink, MismatchesOfARunAreShrunkWithWhatEveryPartySays) {
  const auto liar = test::saboteur([](View in, std::span<std::uint32_t> out, parties::Ending&) {
    if (static_cast<std::int32_t>(in[1]) > 0x10000) out[0] = 0x77;
  });
  const verify::Report report = test::judge(liar, {.operation = cases::Operation::mul});
  ASSERT_FALSE(report.findings[0].shown.empty());
  for (const verify::Mismatch& m : report.findings[0].shown) {
    EXPECT_EQ(m.smallest, (Words{0, 0x20000}));
    ASSERT_EQ(m.said.size(), 2U);
    EXPECT_EQ(m.said[0], (Said{"saboteur", "00000077"}));
    EXPECT_EQ(m.said[1], (Said{"fast", "00000000"}));
  }
}

}  // namespace shrink_test
}  // namespace fixproof
