/// Compares batches on every path of this processor with the function of one angle, for all 2^32
/// angles. `fixproof verify sin cos --level 3` compares that function with the oracle.
#include <atomic>
#include <thread>

#include "fixed/batch/radian.hpp"
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

constexpr std::size_t block = 1 << 16;

/// Compares every `threads`-th block, from `first` on. Stores an angle that differs in `different`.
void compare(batch::path path, unsigned first, unsigned threads,
             std::atomic<std::int64_t>& different) {
  std::vector<q16_16> angles(block);
  std::vector<q16_16> cosines(block);
  std::vector<q16_16> sines(block);
  for (std::uint64_t start = first * block; start < std::uint64_t{1} << 32;
       start += threads * block) {
    for (std::size_t i = 0; i < block; ++i) {
      angles[i] = q16_16::from_raw(static_cast<std::int32_t>(start + i));
    }
    batch::sin_cos(angles, sines, cosines, path);
    for (std::size_t i = 0; i < block; ++i) {
      if (sines[i] != sin(angles[i]) || cosines[i] != cos(angles[i])) {
        different = angles[i].raw();
        return;
      }
    }
  }
}

void expect_same_bits(batch::path path) {
  if (!batch::has(path)) GTEST_SKIP() << "this processor or this build does not have it";
  constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  std::atomic<std::int64_t> different = none;
  const unsigned count = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < count; ++i) {
    threads.emplace_back([=, &different] { compare(path, i, count, different); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(different, none);
}

TEST(EveryAngle, Neon) { expect_same_bits(batch::path::neon); }

TEST(EveryAngle, Avx2) { expect_same_bits(batch::path::avx2); }

TEST(EveryAngle, Avx512) { expect_same_bits(batch::path::avx512); }

}  // namespace
