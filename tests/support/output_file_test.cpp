#include "support/output_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/support/scratch_folder.hpp"

namespace fixproof {
namespace {

std::string write_refusal(const std::string& path) {
  try {
    support::OutputFile file(path);
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

TEST(OutputFile, AppearsWhenItIsFinished) {
  const ScratchFolder folder;
  {
    support::OutputFile file(folder.path("a"));
    file.append("0123");
    file.append("456");
    file.overwrite(2, "xy");
    EXPECT_FALSE(std::filesystem::exists(folder.path("a")));
    file.finish();
    EXPECT_EQ(folder.read("a"), "01xy456");
  }
  EXPECT_EQ(folder.files(), 1);
}

TEST(OutputFile, LeavesTheOldFileUntilThen) {
  const ScratchFolder folder;
  folder.write("a", "old");
  {
    support::OutputFile file(folder.path("a"));
    file.append("new");
    EXPECT_EQ(folder.read("a"), "old");
  }
  EXPECT_EQ(folder.read("a"), "old");
  EXPECT_EQ(folder.files(), 1);
}

TEST(OutputFile, ReplacesWhatALinkLeadsTo) {
  const ScratchFolder folder;
  folder.write("a", "old");
  std::filesystem::create_symlink(folder.path("a"), folder.path("link"));
  support::OutputFile file(folder.path("link"));
  file.append("new");
  file.finish();
  EXPECT_EQ(folder.read("a"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
}

TEST(OutputFile, NamesTheFileAndTheReasonOfAFailure) {
  const ScratchFolder folder;
  EXPECT_EQ(write_refusal(folder.path("none/a")),
            "cannot write " + folder.path("none/a") + ": No such file or directory");
  EXPECT_EQ(write_refusal(folder.path("")), "cannot write " + folder.path("") + ": Is a directory");
  EXPECT_EQ(write_refusal(folder.path(".")),
            "cannot write " + folder.path(".") + ": Is a directory");
}

TEST(OutputFile, OverwritesOnlyRegularFiles) {
  const auto opened = [](const std::string& path) {
    const support::OutputFile file(path, support::OutputFile::Use::overwriting);
  };
  EXPECT_THROW(opened("/dev/null"), std::runtime_error);
  EXPECT_THROW(opened("/dev/stdout"), std::runtime_error);
}

TEST(OutputFile, WritesToWhatIsNoRegularFile) {
  EXPECT_EQ(write_refusal("/dev/null"), "accepted");
  EXPECT_EQ(write_refusal("/dev/full"), "cannot write /dev/full: No space left on device");
  const ScratchFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const support::Descriptor reader(::open(pipe.c_str(), O_RDONLY | O_NONBLOCK));
  EXPECT_EQ(write_refusal(pipe), "accepted");
  std::array<char, 8> got{};
  EXPECT_EQ(::read(reader.number(), got.data(), got.size()), 3);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

// As under `--report /dev/stdout >file`: what else the process writes there stays.
TEST(OutputFile, AppendsToAnOpenDescriptor) {
  const ScratchFolder folder;
  const support::Descriptor file(::open(folder.path("a").c_str(), O_WRONLY | O_CREAT, 0600));
  ASSERT_EQ(file.append("before "), 0);
  EXPECT_EQ(write_refusal("/dev/fd/" + std::to_string(file.number())), "accepted");
  ASSERT_EQ(file.append(" after"), 0);
  EXPECT_EQ(folder.read("a"), "before xyz after");
  const support::Descriptor readable(::open("/dev/null", O_RDONLY));
  EXPECT_NE(write_refusal("/proc/self/fd/" + std::to_string(readable.number())), "accepted");
}

TEST(OutputFile, KeepsTheModeOfTheFileItReplaces) {
  const ScratchFolder folder;
  for (const mode_t mode : {0600U, 0640U, 0664U, 0200U}) {
    folder.write("a", "old");
    ASSERT_EQ(::chmod(folder.path("a").c_str(), mode), 0);
    ASSERT_EQ(write_refusal(folder.path("a")), "accepted");
    struct stat now {};
    ASSERT_EQ(::stat(folder.path("a").c_str(), &now), 0);
    EXPECT_EQ(now.st_mode & 07777U, mode);
    std::filesystem::remove(folder.path("a"));
  }
}

TEST(OutputFile, KeepsTheOwnerOfTheFileItReplaces) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can make a file of another user";
  const ScratchFolder folder;
  const std::string path = folder.write("a", "old");
  ASSERT_EQ(::chown(path.c_str(), 65534, 65533), 0);
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  ASSERT_EQ(write_refusal(path), "accepted");
  struct stat now {};
  ASSERT_EQ(::stat(path.c_str(), &now), 0);
  EXPECT_EQ(now.st_uid, 65534U);
  EXPECT_EQ(now.st_gid, 65533U);
  EXPECT_EQ(now.st_mode & 07777U, 0640U);
}

TEST(OutputFile, RefusesAFileThatNoOneMayWrite) {
  const ScratchFolder folder;
  const std::string path = folder.write("a", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
  EXPECT_EQ(
      write_refusal(path),
      "cannot write " + path + ": the file is read-only; make it writable, or name another file");
  EXPECT_EQ(folder.read("a"), "old");
  EXPECT_EQ(folder.files(), 1);
}

// A run that keeps its state again and again holds its lock in between.
TEST(OutputFile, ReplacesAgainAndAgain) {
  const ScratchFolder folder;
  {
    support::OutputFile file(folder.path("a"));
    for (const char* text : {"one", "two", "three"}) {
      file.replace(text);
      EXPECT_EQ(folder.read("a"), text);
      EXPECT_EQ(write_refusal(folder.path("a")),
                "cannot write " + folder.path("a") +
                    ": another run writes this file; wait for it, or name another");
    }
  }
  EXPECT_EQ(write_refusal(folder.path("a")), "accepted");
  EXPECT_EQ(folder.files(), 1);
}

TEST(OutputFile, ReplacesWholeContentsAfterAFailure) {
  const ScratchFolder folder;
  support::OutputFile file(folder.path("a"));
  {
    const LongestFile limit(2);
    EXPECT_THROW(file.replace("12345"), std::runtime_error);
  }
  file.replace("678");
  EXPECT_EQ(folder.read("a"), "678");
}

TEST(OutputFile, LeavesNothingBehindIfItsPlaceIsTaken) {
  const ScratchFolder folder;
  {
    support::OutputFile file(folder.path("a"));
    file.append("new");
    std::filesystem::create_directories(folder.path("a/b"));
    EXPECT_THROW(file.finish(), std::runtime_error);
  }
  EXPECT_EQ(folder.files(), 1);
}

// Whatever stands where the unfinished file goes is never written to.
TEST(OutputFile, DoesNotWriteThroughALinkNamedLikeItsPart) {
  const ScratchFolder folder;
  folder.write("other", "kept");
  std::filesystem::create_symlink(folder.path("other"), folder.path("a.fixproof-part"));
  EXPECT_EQ(write_refusal(folder.path("a")), "accepted");
  EXPECT_EQ(folder.read("a"), "xyz");
  EXPECT_EQ(folder.read("other"), "kept");
  std::filesystem::create_directory(folder.path("a.fixproof-part"));
  EXPECT_NE(write_refusal(folder.path("a")).find("a.fixproof-part is beside it"),
            std::string::npos);
}

TEST(OutputFile, TooLongForTheDiskIsAFailure) {
  const ScratchFolder folder;
  const LongestFile limit(2);
  EXPECT_EQ(write_refusal(folder.path("a")),
            "cannot write " + folder.path("a") + ": File too large");
  EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace fixproof
