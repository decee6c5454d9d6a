// A log and other processes: the child of a fork, and a second writer of the file.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#define FIXPROOF_RECORD 1
#include "judge/desync/compare.hpp"
#include "tests/fixed/record/sim.hpp"
#include "tests/support/scratch_folder.hpp"

namespace processes_test {

using namespace fixproof;
using desync::LogFile;
using desync::Verdict;
using recorder_test::real;

constexpr std::string_view in_child = "a child process does not write the log of its parent";
constexpr std::string_view in_use = "another process or log has this file open";

/// More than a page of entries, so that finished blocks reach the file.
constexpr int many = 100'000;

/// Runs `run` in a child process, which then ends without destructors. Returns what `run` returns.
template <class Run>
int in_fork(const Run& run) {
  const pid_t child = fork();
  if (child == 0) _exit(run());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class Processes : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const char* name) const { return folder_.path(name); }

  static void add(int count) {
    real sum;
    for (int i = 0; i < count; ++i) sum += q16_16::from_raw(i);
  }

  /// Expects that a log is closed and has exactly the operations of add() for each count.
  template <class... Counts>
  void expect(const char* name, Counts... counts) const {
    {
      const record::log expected(path("expected.log"));
      (add(counts), ...);
    }
    LogFile log(path(name));
    LogFile expected(path("expected.log"));
    EXPECT_TRUE(log.is_complete()) << name;
    const auto found = desync::compare(log, expected);
    EXPECT_EQ(found.verdict, Verdict::equal) << name;
    EXPECT_EQ(log.blocks(), expected.blocks()) << name;
    EXPECT_EQ(std::filesystem::file_size(path(name)),
              std::filesystem::file_size(path("expected.log")));
  }

 private:
  ScratchFolder folder_;
};

TEST_F(Processes, AChildThatExitsWritesNothingToTheLogOfItsParent) {
  {
    const record::log log(path("a.log"));
    add(1500);
    const int in_time = in_fork([&] {
      add(many);
      record::flush();
      return log.good() || log.problem() != in_child ? 1 : 0;
    });
    EXPECT_EQ(in_time, 0);
    EXPECT_TRUE(log.good());
    add(many);
  }
  expect("a.log", 1500, many);
}

TEST_F(Processes, AChildThatDestroysTheLogOfItsParentWritesNothingToIt) {
  auto log = std::make_unique<record::log>(path("a.log"));
  add(1500);
  EXPECT_EQ(in_fork([&] {
              add(many);
              log.reset();
              return 0;
            }),
            0);
  EXPECT_FALSE(record::log(path("a.log")).good()) << "the child took the lock with it";
  add(many);
  log.reset();
  expect("a.log", 1500, many);
}

TEST_F(Processes, AChildThatRecordsInFullWritesNothingToTheLogOfItsParent) {
  const record::options full{.full = {.first = 0, .last = 9}};
  {
    const record::log log(path("a.log"), full);
    add(10);
    in_fork([] {
      record::mark("in the child");
      add(100);
      return 0;
    });
    add(5000);
  }
  {
    const record::log log(path("b.log"), full);
    add(10);
    add(5000);
  }
  LogFile a(path("a.log"));
  LogFile b(path("b.log"));
  EXPECT_EQ(desync::compare(a, b).verdict, Verdict::equal);
  EXPECT_EQ(a.records(0).size(), 1024U);
  EXPECT_EQ(std::filesystem::file_size(path("a.log")), std::filesystem::file_size(path("b.log")));
}

TEST_F(Processes, AChildAndItsChildMayOpenLogsOfTheirOwn) {
  {
    const record::log log(path("a.log"));
    add(700);
    in_fork([&] {
      {
        const record::log own(path("child.log"));
        add(800);
        in_fork([&] {
          add(many);
          const record::log owns(path("grandchild.log"));
          add(many);
          return 0;
        });
        add(many);
      }
      add(many);
      return 0;
    });
    add(900);
  }
  expect("a.log", 700, 900);
  expect("child.log", 800, many);
  expect("grandchild.log", many);
}

TEST_F(Processes, ASecondProcessDoesNotOpenTheFileOfALog) {
  {
    const record::log log(path("a.log"));
    add(1500);
    const int refused = in_fork([&] {
      const record::log second(path("a.log"));
      add(many);
      return second.good() || second.problem() != in_use ? 1 : 0;
    });
    EXPECT_EQ(refused, 0);
    add(many);
  }
  expect("a.log", 1500, many);
}

TEST_F(Processes, ASecondLogOfTheProcessDoesNotOpenTheFile) {
  {
    const record::log log(path("a.log"));
    add(1500);
    std::thread([&] {
      const record::log second(path("a.log"));
      EXPECT_FALSE(second.good());
      EXPECT_EQ(second.problem(), in_use);
      add(many);
    }).join();
    add(many);
  }
  expect("a.log", 1500, many);
}

TEST_F(Processes, TheFileIsFreeWhenItsLogIsDestroyedAlsoWhileAChildRuns) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  auto log = std::make_unique<record::log>(path("a.log"));
  const pid_t child = fork();
  if (child == 0) {
    close(ends[1]);
    char byte = 0;
    _exit(static_cast<int>(read(ends[0], &byte, 1)));  // waits until the parent closes its end
  }
  close(ends[0]);
  add(many);
  log.reset();
  {
    const record::log again(path("a.log"));
    EXPECT_TRUE(again.good());
    EXPECT_STREQ(again.problem(), "");
    add(10);
  }
  expect("a.log", 10);  // shorter than before
  close(ends[1]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST_F(Processes, ManyLogsMayWriteADevice) {
  const record::log log("/dev/null");
  const record::log second("/dev/null");
  EXPECT_TRUE(log.good());
  EXPECT_TRUE(second.good());
}

TEST_F(Processes, ALogThatCannotBeOpenedSaysSo) {
  const record::log log(path("gone/x.log"));
  EXPECT_FALSE(log.good());
  EXPECT_STREQ(log.problem(), "the file cannot be opened");
}

}  // namespace processes_test
