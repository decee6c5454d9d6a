/// Compares the functions of fixed/batch/functions.hpp on the best path with the functions of one
/// number, for all 2^32 words of 16.16 and 2.30. `fixproof verify FUNCTION --level 3` compares
/// those with the oracle.
#include <atomic>
#include <iostream>
#include <thread>

#include "fixed/formats.hpp"
#include "tests/fixed/batch/functions.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

constexpr std::size_t block = 1 << 12;
constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

/// The other operand of a function of two numbers: a word of any length and either sign.
std::int32_t mixed(std::int32_t word) {
  const std::uint32_t product = static_cast<std::uint32_t>(word) * 2654435761U;
  return static_cast<std::int32_t>(product << 5) >> (product >> 27);
}

/// Compares every `threads`-th block, from `first` on. Stores a word that differs in `different`.
template <class N>
void compare(const BatchFunction<N>& f, unsigned first, unsigned threads,
             std::atomic<std::int64_t>& different) {
  Numbers<N> x(block);
  Numbers<N> y(block);
  Numbers<N> results(block);
  for (std::uint64_t start = first * block; start < std::uint64_t{1} << 32 && different == none;
       start += threads * block) {
    for (std::size_t i = 0; i < block; ++i) {
      x[i] = N::from_raw(static_cast<std::int32_t>(start + i));
      y[i] = N::from_raw(mixed(x[i].raw()));
    }
    f.many(x, y, results, batch::best());
    for (std::size_t i = 0; i < block; ++i) {
      if (results[i] != f.one(x[i], y[i])) different = x[i].raw();
    }
  }
}

template <class N>
void expect_same_bits() {
  if (batch::best() == batch::path::portable) GTEST_SKIP() << "this processor has no other path";
  const unsigned count = std::max(1U, std::thread::hardware_concurrency());
  for (const BatchFunction<N>& f : all_functions<N>) {
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

TEST(EveryWord, OfEveryFunction) { expect_same_bits<q16_16>(); }

TEST(EveryWord, OfEveryFunctionWith30FractionBits) { expect_same_bits<q2_30>(); }

}  // namespace
}  // namespace batch_test
