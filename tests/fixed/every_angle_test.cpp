/// All 2^32 angles: a batch on every path that this processor has gives what one angle at a time
/// gives, which `fixproof verify sin cos --level 3` compares with the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "fixed/batch_radian.hpp"

namespace {

using namespace fixed;

constexpr std::size_t block = 1 << 16;

/// Calculates a block on one path; the blocks are whole ones of every register.
using Path = std::size_t (*)(const std::int32_t*, std::int32_t*, std::int32_t*, std::size_t);

/// One of the threads does every `threads`-th block. Returns an angle that differs, if there is
/// one.
void compare(Path path, unsigned first, unsigned threads, std::atomic<std::int64_t>& different) {
  std::vector<std::int32_t> angles(block);
  std::vector<std::int32_t> cosines(block);
  std::vector<std::int32_t> sines(block);
  for (std::uint64_t start = first * block; start < std::uint64_t{1} << 32;
       start += threads * block) {
    for (std::size_t i = 0; i < block; ++i) angles[i] = static_cast<std::int32_t>(start + i);
    ASSERT_EQ(path(angles.data(), cosines.data(), sines.data(), block), block);
    for (std::size_t i = 0; i < block; ++i) {
      if (sines[i] != detail::nearest_sine<16>(angles[i], 0) ||
          cosines[i] != detail::nearest_sine<16>(angles[i], detail::quarter_turn)) {
        different = angles[i];
        return;
      }
    }
  }
}

void expect_same_bits(Path path) {
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

#if defined(FIXED_BATCH_X86)
TEST(EveryAngle, Avx2) {
  if (!batch::has(batch::path::avx2)) GTEST_SKIP() << "this processor has no AVX2";
  expect_same_bits(detail::radian_avx2::both<16>);
}

TEST(EveryAngle, Avx512) {
  if (!batch::has(batch::path::avx512)) GTEST_SKIP() << "this processor has no AVX-512";
  expect_same_bits(detail::radian_avx512::both<16>);
}
#elif defined(FIXED_BATCH_NEON)
TEST(EveryAngle, Neon) { expect_same_bits(detail::radian_neon::both<16>); }
#endif

}  // namespace
