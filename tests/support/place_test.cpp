#include "support/place.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "support/file.hpp"
#include "support/folder_lock.hpp"
#include "tests/support/scratch_folder.hpp"

namespace fixproof {
namespace {

namespace fs = std::filesystem;

std::string refusal(const std::string& path) {
  try {
    static_cast<void>(support::Place(path).check_writable());
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

constexpr uid_t other_user = 65534;

void give_away(const std::string& path) {
  ASSERT_EQ(::lchown(path.c_str(), other_user, other_user), 0);
}

TEST(Place, IsBehindLinks) {
  const ScratchFolder folder;
  fs::create_directory(folder.path("below"));
  fs::create_symlink("below/second", folder.path("first"));
  fs::create_symlink("../end", folder.path("below/second"));
  const support::Place place(folder.path("first"));
  EXPECT_EQ(place.name(), "end");
  EXPECT_TRUE(fs::equivalent(place.folder_path(), folder.path()));
  EXPECT_TRUE(support::same_file(folder.path("first"), folder.path("end")));
  EXPECT_FALSE(support::same_file(folder.path("first"), folder.path("other")));
}

TEST(Place, IsNoEmptyPath) {
  EXPECT_EQ(refusal(""), "cannot write : No such file or directory");
  EXPECT_FALSE(support::same_file("", "/"));
  EXPECT_TRUE(support::same_file("/", "//"));
  EXPECT_NO_THROW(support::FolderLock("--out", "/"));
  EXPECT_NO_THROW(support::FolderLock("--out", "//"));
  EXPECT_THROW(support::FolderLock("--out", ""), std::runtime_error);
}

TEST(Place, HoldsAFileUntilAnotherTakesItsName) {
  const ScratchFolder folder;
  const support::Place place(folder.path("a"));
  const support::Descriptor file(::open(folder.write("a", "").c_str(), O_RDONLY));
  EXPECT_TRUE(place.holds("a", file));
  EXPECT_FALSE(place.holds("b", file));
  fs::rename(folder.write("b", ""), folder.path("a"));
  EXPECT_FALSE(place.holds("a", file));
}

TEST(Place, RefusesALoopOfLinks) {
  const ScratchFolder folder;
  fs::create_symlink("b", folder.path("a"));
  fs::create_symlink("a", folder.path("b"));
  EXPECT_TRUE(has(refusal(folder.path("a")), "Too many levels of symbolic links"));
  EXPECT_TRUE(fs::is_symlink(folder.path("a")));
}

TEST(Place, RefusesALinkOfAnotherUserWhereEveryoneMayWrite) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can make a link of another user";
  const ScratchFolder folder;
  fs::create_directory(folder.path("shared"));
  folder.write("target", "precious");
  const std::string link = folder.path("shared/link");
  fs::create_symlink(folder.path("target"), link);
  fs::create_symlink(folder.path(), folder.path("shared/folder"));
  give_away(link);
  give_away(folder.path("shared/folder"));
  const auto lock = [&](const std::string& name) {
    const support::FolderLock made("--out", folder.path("shared/" + name));
  };

  ASSERT_EQ(::chmod(folder.path("shared").c_str(), 0777), 0);
  EXPECT_EQ(refusal(link), "accepted");
  EXPECT_NO_THROW(lock("folder"));
  ASSERT_EQ(::chmod(folder.path("shared").c_str(), 01777), 0);
  EXPECT_TRUE(has(refusal(link), "a link of another user"));
  EXPECT_THROW(support::replace_file(link, "new"), std::runtime_error);
  EXPECT_EQ(folder.read("target"), "precious");
  EXPECT_THROW(lock("folder"), std::runtime_error);
  EXPECT_THROW(lock("folder//"), std::runtime_error);
  // The owner of the folder may place links in it.
  give_away(folder.path("shared"));
  EXPECT_EQ(refusal(link), "accepted");
}

TEST(Place, RefusesAFileOfAnotherUserWhereOthersMayWrite) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can make a file of another user";
  const ScratchFolder folder;
  fs::create_directory(folder.path("shared"));
  ASSERT_EQ(::mkfifo(folder.path("shared/pipe").c_str(), 0666), 0);
  folder.write("shared/file", "theirs");
  for (const char* name : {"shared/pipe", "shared/file"}) {
    const std::string path = folder.path(name);
    ASSERT_EQ(::chmod(path.c_str(), 0666), 0);
    give_away(path);
    for (const mode_t mode : {01777U, 01770U}) {
      ASSERT_EQ(::chmod(folder.path("shared").c_str(), mode), 0);
      EXPECT_TRUE(has(refusal(path), "a file of another user")) << name;
    }
    ASSERT_EQ(::chmod(folder.path("shared").c_str(), 0777), 0);
    EXPECT_EQ(refusal(path), "accepted") << name;
  }
}

TEST(Place, NamesOnlyOpenDescriptorsOfThisProcess) {
  EXPECT_EQ(support::Place("/dev/stdout").open_descriptor(), 1);
  EXPECT_EQ(support::Place("/proc/self/fd/2").open_descriptor(), 2);
  EXPECT_TRUE(has(refusal("/proc/" + std::to_string(::getppid()) + "/fd/1"), "a link of /proc"));
  EXPECT_TRUE(has(refusal("/proc/self/exe"), "a link of /proc"));
}

}  // namespace
}  // namespace fixproof
