// The life of a log in a program: how logs begin and end, and what reaches the file.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#define FIXPROOF_RECORD 1
#include "judge/desync/compare.hpp"
#include "tests/fixed/record/either.hpp"
#include "tests/fixed/record/shared_library.hpp"
#include "tests/fixed/record/sim.hpp"
#include "tests/support/scratch_folder.hpp"

namespace log_test {

using namespace fixproof;
using desync::LogFile;
using desync::Verdict;
using recorder_test::real;

class Log : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const char* name) const { return folder_.path(name); }

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

TEST_F(Log, HasTheOperationsOfSharedLibraries) {
  const record::log log(path("one.log"));
  const Recorded x(q16_16(3));
  const std::uint64_t before = record::where().records;
  EXPECT_EQ(square_and_sum_in_library(x).plain(), q16_16(12));
  EXPECT_EQ(record::where().records - before, 2U);
}

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

TEST_F(Log, IsClosedAfterAnyNumberOfOperations) {
  for (const int count : {0, 1, 1023, 1024, 1025, 30 * 1024, 60 * 1024}) {
    {
      const record::log log(path("closed.log"));
      add(count);
    }
    expect("closed.log", count);
  }
}

TEST_F(Log, IsAsLongAsTheOther) {
  for (const int count : {0, 1, 1024, 1025, 2048, 30 * 1024}) {
    {
      const record::log log(path("short.log"), {.full = {.first = 0, .last = 99}});
      add(count);
    }
    {
      const record::log log(path("long.log"), {.full = {.first = 0, .last = 99}});
      add(40000);
    }
    LogFile a(path("short.log"));
    LogFile b(path("long.log"));
    const auto found = desync::compare(a, b);
    EXPECT_EQ(found.verdict, count % 1024 == 0 ? Verdict::equal : Verdict::ended) << count;
    EXPECT_EQ(found.operations, static_cast<std::uint64_t>(count));
  }
}

TEST_F(Log, ThatEndsAfterAFullFrameHasNoDifference) {
  for (const auto& [name, frames] : {std::pair("one.log", 1), std::pair("two.log", 2)}) {
    const record::log log(path(name));
    for (int i = 0; i < frames; ++i) {
      record::frame(i);
      add(1023);
    }
  }
  for (const bool swapped : {false, true}) {
    LogFile a(path(swapped ? "two.log" : "one.log"));
    LogFile b(path(swapped ? "one.log" : "two.log"));
    EXPECT_EQ(desync::compare(a, b).verdict, Verdict::equal);
    EXPECT_EQ(desync::compare_last_frames(a, b).verdict, Verdict::equal);
  }
}

TEST_F(Log, HasAllRecordsOfABlockThatIsFlushedMidway) {
  for (const auto& [name, flushes] : {std::pair("a.log", false), std::pair("b.log", true)}) {
    const record::log log(path(name), {.full = {.first = 1, .last = 2}});
    add(1024);
    add(700);
    if (flushes) record::flush();
    if (flushes) record::flush();
    add(2000);
  }
  LogFile a(path("a.log"));
  LogFile b(path("b.log"));
  for (std::uint64_t block = 0; block < 4; ++block) {
    const auto of_a = a.records(block);
    const auto of_b = b.records(block);
    ASSERT_EQ(of_a.size(), block == 1 || block == 2 ? 1024U : 0U);
    ASSERT_EQ(of_b.size(), of_a.size());
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      ASSERT_EQ(of_a[i].words, of_b[i].words) << i;
      ASSERT_EQ(of_a[i].operation, of_b[i].operation) << i;
    }
  }
}

/// A frame is confirmed before its last block is finished. If the program is then killed, the log
/// must not say that the frame is final, because it has only its start.
TEST_F(Log, DoesNotConfirmAFrameThatItHasNotFinished) {
  {
    const record::log log(path("frames.log"));
    record::frame(1);
    add(10);
    record::frame(2);
    add(2000);
    record::confirm(2);
    record::flush();
    LogFile killed(path("frames.log"));
    EXPECT_EQ(killed.blocks(), 2U);
    EXPECT_EQ(killed.confirmed(), record::no_frame);
    record::frame(3);
    record::mark("a name has a page of its own");
    EXPECT_EQ(LogFile(path("frames.log")).confirmed(), record::no_frame);
    record::flush();
    EXPECT_EQ(LogFile(path("frames.log")).confirmed(), 2);
    record::confirm(3);
  }
  EXPECT_EQ(LogFile(path("frames.log")).confirmed(), 3);
}

TEST_F(Log, HasNoOldNameForAMarkWithoutRoom) {
  {
    const record::log log(path("names.log"));
    for (int i = 0; i < 4097; ++i) record::mark("name " + std::to_string(i));
    record::frame(1);
    add(1);
  }
  LogFile log(path("names.log"));
  EXPECT_EQ(log.name(4096), "name 4095");
  EXPECT_EQ(log.entry(log.blocks() - 1).name, 0U);
}

TEST_F(Log, NamesABlockAfterTheMarkThatEndsTheOneBefore) {
  {
    const record::log log(path("names.log"));
    record::mark("old");
    add(1022);
    record::mark("new");  // record 1,024
    add(1);
  }
  LogFile log(path("names.log"));
  ASSERT_EQ(log.blocks(), 2U);
  EXPECT_EQ(log.name(log.entry(1).name), "new");
}

TEST_F(Log, HasAPositionThatDependsOnlyOnTheRecords) {
  for (const int count : {0, 1, 1000, 1023, 1024, 5000}) {
    record::position with_hashes;
    for (const bool is_full : {false, true}) {
      const std::int64_t last = is_full ? 1 : -1;
      const record::log log(path("where.log"), {.full = {.first = 0, .last = last}});
      record::frame(3);
      add(count);
      const record::position here = record::where();
      EXPECT_EQ(here.records, static_cast<std::uint64_t>(count) + 1);
      if (is_full) {
        EXPECT_EQ(here, with_hashes) << count;
      }
      with_hashes = here;
      add(1);
      EXPECT_NE(record::where().hash, here.hash);
    }
  }
}

TEST_F(Log, KeepsTheBytesOfNames) {
  const std::string umlaut = "K\xc3\xb6ln";
  const std::string other = "\xff\xfe\x01";  // no UTF-8
  {
    const record::log log(path("names.log"), {.program = umlaut});
    record::mark(other);
  }
  LogFile log(path("names.log"));
  EXPECT_TRUE(log.origin().starts_with("program: " + umlaut + '\n')) << log.origin();
  EXPECT_EQ(log.name(1), other);
}

TEST_F(Log, RecordsAProgramThatAlsoCompilesWithoutRecording) {
  EXPECT_EQ(recorder_test::run_either(path("on.log")), q16_16(6.5).raw());
  EXPECT_TRUE(std::filesystem::exists(path("on.log")));
}

TEST_F(Log, SaysWhatIsRecordedInFull) {
  struct Case {
    const char* range;
    const char* text;
  };
  for (const auto& [range, text] : {Case{"97-98", "blocks 97 to 98"},
                                    {"frames:12-13", "frames 12 to 13"},
                                    {"frames:-2--1", "frames -2 to -1"},
                                    {"frames:-9223372036854775807-9223372036854775807",
                                     "frames -9223372036854775807 to 9223372036854775807"},
                                    {"98-97", "nothing"},
                                    {"-1-5", "nothing"},
                                    {"97", "nothing"},
                                    {"97-", "nothing"},
                                    {"97-98 ", "nothing"},
                                    {"", "nothing"},
                                    {"frames:", "nothing"},
                                    {"0-9223372036854775808", "nothing"}}) {
    { const record::log log(path("full.log"), {.full = record::full_range::from_text(range)}); }
    EXPECT_TRUE(LogFile(path("full.log"))
                    .origin()
                    .ends_with("\nrecorded in full: " + std::string(text) + '\n'))
        << range;
  }
}

TEST_F(Log, RecordsNegativeFramesInFull) {
  {
    const record::log log(path("frames.log"),
                          {.full = record::full_range::from_text("frames:-1--1")});
    for (const int frame : {-2, -1, 0}) {
      record::frame(frame);
      add(3);
    }
  }
  LogFile log(path("frames.log"));
  EXPECT_TRUE(log.records(0).empty());
  EXPECT_EQ(log.records(1).size(), 4U);
  EXPECT_TRUE(log.records(2).empty());
}

TEST_F(Log, OfAFullDiskDoesNotStopTheProgram) {
  if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const record::log log("/dev/full");
  add(100000);
  EXPECT_FALSE(log.good());
  EXPECT_STREQ(log.problem(), "the file cannot be written");
}

TEST_F(Log, HasTheDoubleWhoseConversionThrows) {
  {
    const record::log log(path("throws.log"), {.full = {.first = 0, .last = 0}});
    EXPECT_THROW((void)recorded<q16_16_trapping>(1e9), overflow_error);
  }
  LogFile log(path("throws.log"));
  EXPECT_EQ(log.records(0).at(0).input, std::bit_cast<std::uint64_t>(1e9));
}

}  // namespace log_test
