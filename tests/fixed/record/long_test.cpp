// Plants a difference in operation 10^8 and finds it in seconds, with two runs of each side.
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include "judge/desync/compare.hpp"
#include "tests/fixed/record/sim.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using namespace fixproof;
using recorder_test::Plant;

TEST(LongRun, OperationTenToTheEight) {
  const ScratchFolder folder;
  const std::string a = folder.path("a.log");
  const std::string b = folder.path("b.log");
  constexpr std::uint64_t turns = 25'100'000;
  constexpr std::uint64_t at = 25'000'000;
  record::full_range full;
  for (int pass = 0; pass < 2; ++pass) {
    recorder_test::run(a, turns, Plant::nothing, 0, full);
    recorder_test::run(b, turns, Plant::order, at, full);
    EXPECT_LT(std::filesystem::file_size(a), 8'000'000U);
    desync::LogFile first(a);
    desync::LogFile second(b);
    const desync::Comparison found = desync::compare(first, second);
    if (pass == 0) {
      ASSERT_EQ(found.verdict, desync::Verdict::block);
      EXPECT_LE(found.steps, 20U);
      EXPECT_LE(first.pages_read() + second.pages_read(), 600U);
      full.first = static_cast<std::int64_t>(found.a.block);
      full.last = full.first + 1;
      continue;
    }
    EXPECT_EQ(found.verdict, desync::Verdict::order);
    ASSERT_TRUE(found.a.index);
    // The constant and the turn's own from_raw() come first.
    EXPECT_EQ(found.a.records[*found.a.index].operation, 1 + 4 * at + 1);
  }
}

}  // namespace
