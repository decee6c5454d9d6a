#include "support/file_lock.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "support/output_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace fixproof {
namespace {

TEST(FileLock, RefusesASecondRun) {
  const ScratchFolder folder;
  const support::Place place(folder.path("a"));
  {
    const support::FileLock first(place);
    EXPECT_THROW(support::FileLock{place}, std::runtime_error);
    EXPECT_TRUE(std::filesystem::exists(folder.path("a.fixproof-lock")));
  }
  EXPECT_EQ(folder.files(), 0);
  EXPECT_NO_THROW(support::FileLock{place});
}

// A name behind a link is the same file.
TEST(FileLock, LocksWhatALinkLeadsTo) {
  const ScratchFolder folder;
  std::filesystem::create_symlink("a", folder.path("link"));
  const support::Place link(folder.path("link"));
  const support::Place place(folder.path("a"));
  const support::FileLock first(link);
  EXPECT_THROW(support::FileLock{place}, std::runtime_error);
}

TEST(FileLock, RemovesWhatAKilledRunHasLeft) {
  const ScratchFolder folder;
  folder.write("a.fixproof-lock", "");
  folder.write("a.fixproof-part", "half");
  support::OutputFile(folder.path("a")).replace("whole");
  EXPECT_EQ(folder.read("a"), "whole");
  EXPECT_EQ(folder.files(), 1);
}

TEST(FileLock, IsTakenThroughNoLink) {
  const ScratchFolder folder;
  std::filesystem::create_symlink("elsewhere", folder.path("a.fixproof-lock"));
  const support::Place place(folder.path("a"));
  EXPECT_THROW(support::FileLock{place}, std::runtime_error);
  EXPECT_FALSE(std::filesystem::exists(folder.path("elsewhere")));
}

TEST(FileLock, IsNotForUnfinishedFiles) {
  const ScratchFolder folder;
  for (const char* name : {"a.fixproof-part", "a.fixproof-lock"}) {
    const support::Place place(folder.path(name));
    EXPECT_THROW(support::FileLock{place}, std::runtime_error);
  }
}

TEST(Leftovers, OnlyThoseOfLiveRunsStay) {
  const ScratchFolder folder;
  folder.write("dead.fixproof-part", "half");
  folder.write("dead.fixproof-lock", "");
  folder.write("older.fixproof-part", "half");
  folder.write("mine.part", "another program's");
  support::OutputFile live(folder.path("live"));
  live.append("half");
  support::remove_leftovers(folder.path());
  EXPECT_EQ(folder.files(), 3);
  EXPECT_EQ(folder.read("mine.part"), "another program's");
  EXPECT_EQ(folder.read("live.fixproof-part"), "half");
  live.finish();
  EXPECT_EQ(folder.read("live"), "half");
}

// Another user of a shared folder could plant the link, and must not choose what is removed.
TEST(Leftovers, BehindALinkStay) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder.path("out"));
  std::filesystem::create_directories(folder.path("home"));
  for (const std::string& target : {std::string("../home/y"), folder.path("home/y")}) {
    folder.write("out/x.fixproof-part", "planted");
    folder.write("home/y.fixproof-part", "precious");
    std::filesystem::create_symlink(target, folder.path("out/x"));
    support::remove_leftovers(folder.path("out"));
    EXPECT_EQ(folder.read("home/y.fixproof-part"), "precious");
    std::filesystem::remove(folder.path("out/x"));
  }
  // Names that lead to the folder itself and to the one above it.
  folder.write("out/..fixproof-part", "planted");
  folder.write("out/...fixproof-part", "planted");
  folder.write("..fixproof-part", "precious");
  support::remove_leftovers(folder.path("out"));
  EXPECT_EQ(folder.read("..fixproof-part"), "precious");
}

TEST(Leftovers, OfNoFolderAreNone) {
  const ScratchFolder folder;
  EXPECT_NO_THROW(support::remove_leftovers(folder.path("none")));
}

}  // namespace
}  // namespace fixproof
