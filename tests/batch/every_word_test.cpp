/// Compares the functions of batch/functions.hpp on the best path with the functions of one number,
/// for all 2^32 words of 16.16. `fixproof verify FUNCTION --level 3` compares those with the
/// oracle.
#include <atomic>
#include <iostream>
#include <thread>

#include "tests/batch/functions.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

constexpr std::size_t block = 1 << 16;
constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

/// Compares every `threads`-th block, from `first` on. Stores a word that differs in `different`.
void compare(const BatchFunction<q16_16>& f, unsigned first, unsigned threads,
             std::atomic<std::int64_t>& different) {
  Numbers<q16_16> x(block);
  Numbers<q16_16> results(block);
  for (std::uint64_t start = first * block; start < std::uint64_t{1} << 32 && different == none;
       start += threads * block) {
    for (std::size_t i = 0; i < block; ++i) {
      x[i] = q16_16::from_raw(static_cast<std::int32_t>(start + i));
    }
    f.many(x, x, results, batch::best());
    for (std::size_t i = 0; i < block; ++i) {
      if (results[i] != f.one(x[i], x[i])) different = x[i].raw();
    }
  }
}

TEST(EveryWord, OfEveryFunction) {
  if (batch::best() == batch::path::portable) GTEST_SKIP() << "this processor has no other path";
  const unsigned count = std::max(1U, std::thread::hardware_concurrency());
  for (const BatchFunction<q16_16>& f : all_functions<q16_16>) {
    std::atomic<std::int64_t> different = none;
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < count; ++i) {
      threads.emplace_back([&f, i, count, &different] { compare(f, i, count, different); });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(different, none) << f.name;
    std::cout << f.name << ": all words\n" << std::flush;
  }
}

}  // namespace
}  // namespace batch_test
