#include "xsharp/files/part_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/xsharp/raster/scratch_folder.hpp"

namespace xsharp {
namespace {

/// The message of the exception that writing to the path ends in.
std::string refusal(const std::string& path) {
  try {
    PartFile file(path);
    file.append("x");
    file.finish();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PartFile, AppearsWhenItIsFinished) {
  const ScratchFolder folder;
  PartFile file(folder.path("a"));
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
    PartFile file(folder.path("a"));
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
  PartFile file(folder.path("link"));
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
  PartFile file(folder.path("a"));
  file.append("new");
  std::filesystem::create_directories(folder.path("a/b"));
  EXPECT_THROW(file.finish(), std::runtime_error);
  EXPECT_EQ(folder.files(), 1);
}

TEST(PartFile, AFullDiskIsAFailure) {
  // /dev/full takes no byte; the file beside is made a link to it.
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const ScratchFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.path("a.part"));
  EXPECT_EQ(refusal(folder.path("a")),
            "cannot write " + folder.path("a") + ": No space left on device");
  EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace xsharp
