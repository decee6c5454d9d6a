#include "support/part_file.hpp"

#include <sys/resource.h>

#include <csignal>
#include <filesystem>

#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace fixproof {
namespace {

std::string refusal(const std::string& path) {
  try {
    support::PartFile file(path);
    file.append("xyz");
    file.finish();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

/// Limits the size of every file of this process during its lifetime.
class LongestFile {
 public:
  explicit LongestFile(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    signal_ = ::signal(SIGXFSZ, SIG_IGN);
  }
  ~LongestFile() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, signal_);
  }
  LongestFile(const LongestFile&) = delete;
  LongestFile(LongestFile&&) = delete;
  LongestFile& operator=(const LongestFile&) = delete;
  LongestFile& operator=(LongestFile&&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int) = nullptr;
};

TEST(PartFile, AppearsWhenItIsFinished) {
  const ScratchFolder folder;
  support::PartFile file(folder.path("a"));
  file.append("0123");
  file.append("456");
  file.overwrite(2, "xy");
  EXPECT_FALSE(std::filesystem::exists(folder.path("a")));
  file.finish();
  EXPECT_EQ(folder.read("a"), "01xy456");
  EXPECT_EQ(folder.files(), 1);
}

TEST(PartFile, LeavesTheOldFileUntilThen) {
  const ScratchFolder folder;
  folder.write("a", "old");
  {
    support::PartFile file(folder.path("a"));
    file.append("new");
    EXPECT_EQ(folder.read("a"), "old");
  }
  EXPECT_EQ(folder.read("a"), "old");
  EXPECT_EQ(folder.files(), 1);
}

TEST(PartFile, ReplacesWhatALinkLeadsTo) {
  const ScratchFolder folder;
  folder.write("a", "old");
  std::filesystem::create_symlink(folder.path("a"), folder.path("link"));
  support::PartFile file(folder.path("link"));
  file.append("new");
  file.finish();
  EXPECT_EQ(folder.read("a"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
}

TEST(PartFile, NamesTheFileAndTheReasonOfAFailure) {
  const ScratchFolder folder;
  EXPECT_EQ(refusal(folder.path("none/a")),
            "cannot write " + folder.path("none/a") + ": No such file or directory");
  EXPECT_EQ(refusal("/dev/null"), "cannot write /dev/null: not a regular file");
  EXPECT_EQ(refusal(folder.path("")), "cannot write " + folder.path("") + ": not a regular file");
}

TEST(PartFile, LeavesNothingBehindIfItsPlaceIsTaken) {
  const ScratchFolder folder;
  support::PartFile file(folder.path("a"));
  file.append("new");
  std::filesystem::create_directories(folder.path("a/b"));
  EXPECT_THROW(file.finish(), std::runtime_error);
  EXPECT_EQ(folder.files(), 1);
}

TEST(PartFile, TouchesNoOtherPartOfTheSameFile) {
  const ScratchFolder folder;
  folder.write("other", "kept");
  std::filesystem::create_symlink(folder.path("other"), folder.path("a.part"));
  support::PartFile first(folder.path("a"));
  support::PartFile second(folder.path("a"));
  first.append("first");
  second.append("second");
  first.finish();
  EXPECT_EQ(folder.read("a"), "first");
  second.finish();
  EXPECT_EQ(folder.read("a"), "second");
  EXPECT_EQ(folder.read("other"), "kept");
  EXPECT_EQ(folder.files(), 3);
}

TEST(PartFile, TooLongForTheDiskIsAFailure) {
  const ScratchFolder folder;
  const LongestFile limit(2);
  EXPECT_EQ(refusal(folder.path("a")), "cannot write " + folder.path("a") + ": File too large");
  EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace fixproof
