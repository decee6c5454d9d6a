/// Tests that the RapidCheck generators reach the edges and that they shrink.
#include "judge/property/generator.hpp"

#include <rapidcheck.h>

#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

template <class Number>
std::set<std::int64_t> generated(int count) {
  const auto gen = rc::gen::arbitrary<Number>();
  std::set<std::int64_t> raws;
  for (int i = 0; i < count; ++i) {
    raws.insert(gen(rc::Random(static_cast<std::uint64_t>(i)), rc::kNominalSize).value().raw());
  }
  return raws;
}

TEST(Generators, ReachTheEdges) {
  const auto wide = generated<q16_16>(20000);
  for (const std::int64_t edge :
       {0LL, 1LL, -1LL, 0x7fffLL, 0x8000LL, 0x8001LL, -0x8000LL, 0xffffLL, 0x10000LL, 0x10001LL,
        0x7fffffffLL, -0x80000000LL, -0x7fffffffLL, 1LL << 20, -(1LL << 27), (1LL << 29) - 1}) {
    EXPECT_TRUE(wide.contains(edge)) << edge;
  }
  // The edges are only a small part of the values.
  EXPECT_GT(wide.size(), 8000U);
  const auto half = generated<q8_8>(20000);
  for (const std::int64_t edge : {0, 1, -1, 0x7f, 0x80, 0x81, 0xff, 0x100, 0x7fff, -0x8000}) {
    EXPECT_TRUE(half.contains(edge)) << edge;
  }
}

template <class Number, class Property>
Number shrunk(std::uint64_t seed, const Property& holds) {
  auto example = rc::gen::arbitrary<Number>()(rc::Random(seed), rc::kNominalSize);
  if (holds(example.value())) return Number();
  for (bool smaller = true; smaller;) {
    smaller = false;
    auto candidates = example.shrinks();
    while (auto candidate = candidates.next()) {
      if (!holds(candidate->value())) {
        example = *candidate;
        smaller = true;
        break;
      }
    }
  }
  return example.value();
}

TEST(Generators, ShrinkToTheBoundary) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto least = shrunk<q16_16>(seed, [](q16_16 x) { return x < q16_16(100); });
    if (least == q16_16()) continue;
    ++found;
    EXPECT_EQ(least, q16_16(100)) << seed;
  }
  EXPECT_GT(found, 20);
  // Shrinking also starts from the lowest number, which is its own negation.
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto least = shrunk<q8_8>(seed, [](q8_8 x) { return x >= q8_8(-3); });
    if (least == q8_8()) continue;
    EXPECT_EQ(least, q8_8::from_raw(-0x301)) << seed;
  }
}

TEST(Generators, ShowValueAndStoredInteger) {
  std::ostringstream out;
  rc::show(q16_16(1.5), out);
  EXPECT_EQ(out.str(), "1.5 (raw 98304)");
}

}  // namespace
