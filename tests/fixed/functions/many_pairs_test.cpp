/// Compares functions of two numbers with the oracle on many random pairs of 16.16. Takes minutes:
/// ./test release -L slow -R ManyPairs
#include <atomic>
#include <cstdint>
#include <optional>
#include <thread>

#include "tests/fixed/functions/functions.hpp"

namespace {

using namespace fixproof;
using oracle::Function;

constexpr std::uint64_t billion = 1'000'000'000;

/// SplitMix64 (Steele, Lea, Flood 2014): maps a counter to a word that looks random.
constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

struct Pair {
  q16_16 x;
  q16_16 y;
};

/// Pair `number`, whose words have any length.
Pair pair_of(std::uint64_t number) {
  const std::uint64_t bits = mix(number);
  const std::uint64_t lengths = mix(bits);
  const auto word = [](std::uint64_t half, std::uint64_t length) {
    return q16_16::from_raw(static_cast<std::int32_t>(half) >> length % 32);
  };
  return {word(bits, lengths), word(bits >> 32, lengths >> 32)};
}

/// The first pair below `count` for which `compute` is wrong.
template <class Compute>
std::optional<std::uint64_t> wrong_pair(Function function, std::uint64_t count,
                                        const Compute& compute) {
  const std::uint64_t threads = std::max(1U, std::thread::hardware_concurrency());
  std::atomic<std::uint64_t> wrong{count};
  const auto try_every = [&](std::uint64_t first) {
    constexpr std::int64_t highest = std::numeric_limits<std::int32_t>::max();
    constexpr std::int64_t lowest = std::numeric_limits<std::int32_t>::min();
    for (std::uint64_t i = first; i < wrong; i += threads) {
      const auto [x, y] = pair_of(i);
      const auto ulps =
          oracle::fast::nearest(function, x.raw(), y.raw(), 16, oracle::Rounding::half_up);
      if (!ulps || compute(x, y, i).raw() == std::clamp(*ulps, lowest, highest)) continue;
      std::uint64_t known = wrong;
      while (i < known && !wrong.compare_exchange_weak(known, i)) {
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (std::uint64_t i = 0; i < threads; ++i) workers.emplace_back(try_every, i);
  }
  return wrong < count ? std::optional(wrong.load()) : std::nullopt;
}

TEST(ManyPairs, AnglesAreNearest) {
  EXPECT_EQ(wrong_pair(Function::atan2, billion,
                       [](q16_16 y, q16_16 x, std::uint64_t /*i*/) { return atan2(y, x); }),
            std::nullopt);
}

TEST(ManyPairs, LengthsAreNearest) {
  EXPECT_EQ(wrong_pair(Function::hypot, billion / 10,
                       [](q16_16 x, q16_16 y, std::uint64_t /*i*/) { return hypot(x, y); }),
            std::nullopt);
}

TEST(ManyPairs, PowersAreNearest) {
  EXPECT_EQ(wrong_pair(Function::pow, billion / 10,
                       [](q16_16 x, q16_16 y, std::uint64_t /*i*/) { return pow(x, y); }),
            std::nullopt);
}

TEST(ManyPairs, OneWrongUlpInABillionIsSeen) {
  constexpr std::uint64_t planted = 987'654'321;
  EXPECT_EQ(wrong_pair(Function::atan2, billion,
                       [](q16_16 y, q16_16 x, std::uint64_t i) {
                         const q16_16 angle = atan2(y, x);
                         return i == planted ? q16_16::from_raw(angle.raw() + 1) : angle;
                       }),
            planted);
}

}  // namespace
