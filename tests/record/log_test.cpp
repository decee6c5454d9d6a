// The life of a log in a program: how logs begin and end, and what reaches the file.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "desync/compare.hpp"
#include "tests/record/sim.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using namespace fixproof;
using desync::LogFile;
using desync::Verdict;
using recorder_test::real;

class Log : public testing::Test {
 protected:
  std::string path(const char* name) const { return folder_.path(name); }

  static void add(int count) {
    real sum;
    for (int i = 0; i < count; ++i) sum += q16_16::from_raw(i);
  }

  /// Expects that a log is closed and has exactly the operations of add(count).
  void expect(const char* name, int count) const {
    {
      const record::log expected(path("expected.log"));
      add(count);
    }
    LogFile log(path(name));
    LogFile expected(path("expected.log"));
    EXPECT_TRUE(log.is_complete()) << name;
    const auto found = desync::compare(log, expected);
    EXPECT_EQ(found.verdict, Verdict::equal) << name;
    EXPECT_EQ(found.operations, static_cast<std::uint64_t>(count)) << name;
    EXPECT_EQ(log.blocks(), expected.blocks()) << name;
  }

 private:
  ScratchFolder folder_;
};

TEST_F(Log, MayReplaceAnOlderOneThatIsDestroyedFirst) {
  auto log = std::make_unique<record::log>(path("one.log"));
  add(1500);
  log = std::make_unique<record::log>(path("two.log"));  // opens the second, then closes the first
  add(2500);
  log.reset();
  add(3000);  // without a log
  EXPECT_EQ(record::where(), record::position());
  expect("one.log", 1500);
  expect("two.log", 2500);
}

TEST_F(Log, InsideAnotherTakesTheRecordsUntilItEnds) {
  {
    const record::log outer(path("outer.log"));
    add(700);
    {
      const record::log inner(path("inner.log"));
      add(5000);
    }
  }
  expect("outer.log", 700);
  expect("inner.log", 5000);
}

TEST_F(Log, OfEachThreadIsItsOwn) {
  const record::log here(path("here.log"));
  std::thread([&] {
    add(10);  // this thread has no log
    const record::log there(path("there.log"));
    add(40000);
  }).join();
  EXPECT_EQ(record::where().records, 0U);
  expect("there.log", 40000);
}

TEST_F(Log, ThatOutlivesItsThreadHasTheFinishedBlocks) {
  std::optional<record::log> log;
  std::thread([&] {
    log.emplace(path("late.log"));
    add(3000);
  }).join();
  log.reset();
  LogFile late(path("late.log"));
  EXPECT_FALSE(late.is_complete());
  EXPECT_EQ(late.blocks(), 2U);
}

}  // namespace
