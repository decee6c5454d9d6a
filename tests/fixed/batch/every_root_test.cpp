/// Checks batch::sqrt for all 2^32 words of 16.16, on every path and in every rounding mode of the
/// processor, by the definition of a nearest root: (r - 1/2)^2 < n < (r + 1/2)^2.
#include <atomic>
#include <iostream>
#include <thread>

#include "tests/fixed/batch/expected.hpp"
#include "tests/support/rounding_mode.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

using fixproof::q16_16;

constexpr std::int64_t block = 1 << 14;
constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();

/// r^2 - r < n <= r^2 + r in integers; a negative operand has the root 0.
std::uint32_t is_wrong(std::int64_t raw, std::int64_t root) {
  const std::int64_t n = std::max<std::int64_t>(raw, 0) * 65536;
  const std::int64_t square = root * root;
  return static_cast<std::uint32_t>(root < 0) | static_cast<std::uint32_t>(n > square + root) |
         static_cast<std::uint32_t>(n <= square - root && n != 0) |
         static_cast<std::uint32_t>(n == 0 && root != 0);
}

void check(fixproof::batch::path path, int mode, std::int64_t first, std::int64_t step,
           std::atomic<std::int64_t>& wrong) {
  const RoundingMode set(mode);
  std::vector<q16_16> x(block);
  std::vector<q16_16> roots(block);
  for (std::int64_t start = std::numeric_limits<std::int32_t>::min() + first * block;
       start <= std::numeric_limits<std::int32_t>::max() && wrong == none; start += step * block) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = q16_16::from_raw(static_cast<std::int32_t>(start + static_cast<std::int64_t>(i)));
    }
    fixproof::batch::sqrt(x, roots, {path, {}});
    std::uint32_t any = 0;
    for (std::size_t i = 0; i < x.size(); ++i) any |= is_wrong(x[i].raw(), roots[i].raw());
    if (any != 0) wrong = start;
  }
}

TEST(EveryRoot, OfEveryPathInEveryRoundingMode) {
  const unsigned count = std::max(1U, std::thread::hardware_concurrency());
  for (const auto path : paths()) {
    for (const int mode : RoundingMode::all) {
      std::atomic<std::int64_t> wrong = none;
      std::vector<std::thread> threads;
      for (unsigned i = 0; i < count; ++i) {
        threads.emplace_back([=, &wrong] { check(path, mode, i, count, wrong); });
      }
      for (std::thread& thread : threads) thread.join();
      EXPECT_EQ(wrong, none) << "path " << static_cast<int>(path) << ", mode " << mode;
      std::cout << "path " << static_cast<int>(path) << ", mode " << mode << ": all words\n"
                << std::flush;
    }
  }
}

}  // namespace
}  // namespace batch_test
