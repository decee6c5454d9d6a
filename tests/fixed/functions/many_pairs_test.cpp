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

/// Pair `number` in the domain of pow without a pole: x > 0, or a whole y, not negative if x is 0.
Pair power_of(std::uint64_t number) {
  const auto [x, y] = pair_of(number);
  if (x.raw() > 0) return {x, y};
  // Of any length, too.
  const int whole = static_cast<std::int16_t>(mix(~number)) >> number % 16;
  return {x, q16_16(x.raw() == 0 ? whole & 0x7FFF : whole)};
}

/// How many pairs were compared, and the first for which `compute` is wrong.
struct Comparison {
  std::uint64_t compared = 0;
  std::optional<std::uint64_t> wrong;
};

/// Compares the pairs below `count`. Stops after a wrong one.
template <class Compute>
Comparison compare(Function function, std::uint64_t count, Pair (*pair)(std::uint64_t),
                   const Compute& compute) {
  const std::uint64_t threads = std::max(1U, std::thread::hardware_concurrency());
  std::atomic<std::uint64_t> wrong{count};
  std::atomic<std::uint64_t> compared{0};
  const auto try_every = [&](std::uint64_t first) {
    constexpr std::int64_t highest = std::numeric_limits<std::int32_t>::max();
    constexpr std::int64_t lowest = std::numeric_limits<std::int32_t>::min();
    std::uint64_t pairs = 0;
    for (std::uint64_t i = first; i < wrong; i += threads) {
      const auto [x, y] = pair(i);
      const auto ulps =
          oracle::fast::nearest(function, x.raw(), y.raw(), 16, oracle::Rounding::half_up);
      if (!ulps) continue;
      ++pairs;
      if (compute(x, y, i).raw() == std::clamp(*ulps, lowest, highest)) continue;
      std::uint64_t known = wrong;
      while (i < known && !wrong.compare_exchange_weak(known, i)) {
      }
    }
    compared += pairs;
  };
  {
    std::vector<std::jthread> workers;
    for (std::uint64_t i = 0; i < threads; ++i) workers.emplace_back(try_every, i);
  }
  return {compared, wrong < count ? std::optional(wrong.load()) : std::nullopt};
}

template <class Compute>
void expect_nearest(Function function, std::uint64_t count, Pair (*pair)(std::uint64_t),
                    const Compute& compute) {
  const Comparison result = compare(function, count, pair, compute);
  EXPECT_EQ(result.wrong, std::nullopt);
  EXPECT_EQ(result.compared, count);
}

TEST(ManyPairs, AnglesAreNearest) {
  expect_nearest(Function::atan2, billion, pair_of,
                 [](q16_16 y, q16_16 x, std::uint64_t /*i*/) { return atan2(y, x); });
}

TEST(ManyPairs, LengthsAreNearest) {
  expect_nearest(Function::hypot, billion / 10, pair_of,
                 [](q16_16 x, q16_16 y, std::uint64_t /*i*/) { return hypot(x, y); });
}

TEST(ManyPairs, PowersAreNearest) {
  expect_nearest(Function::pow, billion / 10, power_of,
                 [](q16_16 x, q16_16 y, std::uint64_t /*i*/) { return pow(x, y); });
}

TEST(ManyPairs, OneWrongUlpInABillionIsSeen) {
  constexpr std::uint64_t planted = 987'654'321;
  const Comparison result =
      compare(Function::atan2, billion, pair_of, [](q16_16 y, q16_16 x, std::uint64_t i) {
        const q16_16 angle = atan2(y, x);
        return i == planted ? q16_16::from_raw(angle.raw() + 1) : angle;
      });
  EXPECT_EQ(result.wrong, planted);
}

}  // namespace
