#include "support/bounded_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/support/scratch_folder.hpp"

namespace fixproof {
namespace {

namespace fs = std::filesystem;

template <class Read>
std::string said(Read read) {
  try {
    return read();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::string read(const std::string& file) {
  return said([&] { return support::read_bounded(file, 1U << 20U); });
}

TEST(BoundedFile, ReadsRegularFilesUpToALimit) {
  const ScratchFolder folder;
  EXPECT_EQ(read(folder.write("a", "text")), "text");
  EXPECT_EQ(read(folder.write("full", std::string(1U << 20U, 'x'))), std::string(1U << 20U, 'x'));
  EXPECT_EQ(read(folder.write("more", std::string((1U << 20U) + 1, 'x'))), "longer than 1 MiB");
  EXPECT_EQ(read(folder.write("empty", "")), "empty");
  EXPECT_EQ(read(folder.path("none")), "there is no such file");
  EXPECT_EQ(read(folder.path()), "not a regular file");
  EXPECT_EQ(read("/dev/zero"), "not a regular file");
  // A pipe without a writer would make open() wait.
  ASSERT_EQ(::mkfifo(folder.path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(read(folder.path("pipe")), "not a regular file");
  // Regular to stat(), but reading waits for messages. Opening it needs root.
  const std::string messages = read("/proc/kmsg");
  EXPECT_TRUE(messages == "empty" || messages.starts_with("cannot be opened: ")) << messages;
}

using Open = support::Descriptor (*)(const std::string&, const std::string&);
class Beneath : public testing::TestWithParam<Open> {};

TEST_P(Beneath, NothingLeadsOutOfTheFolder) {
  const ScratchFolder folder;
  fs::create_directories(folder.path("in/deeper"));
  folder.write("out", "x");
  folder.write("in/a", "x");
  folder.write("in/deeper/b", "x");
  fs::create_symlink("deeper/b", folder.path("in/link"));
  fs::create_symlink("../out", folder.path("in/leaving"));
  fs::create_symlink("..", folder.path("in/up"));
  fs::create_symlink("in", folder.path("in_too"));
  fs::create_directory(folder.path("in_beside"));
  folder.write("in_beside/c", "x");
  const auto opened = [&](const std::string& file) -> std::string {
    return said(
        [&] { return GetParam()(folder.path("in"), file).is_open() ? "opened" : "closed"; });
  };
  for (const char* file : {"a", "deeper/b", "link", "deeper/../a", "./a"}) {
    EXPECT_EQ(opened(file), "opened") << file;
  }
  for (const std::string& file :
       {std::string("../out"), std::string("leaving"), std::string("up/out"),
        std::string("../in_beside/c"), folder.path("out"), folder.path("in/a")}) {
    EXPECT_EQ(opened(file), "leads out of the folder") << file;
  }
  EXPECT_EQ(opened("none"), "there is no such file");
  EXPECT_TRUE(GetParam()(folder.path("in_too"), "a").is_open());
}

INSTANTIATE_TEST_SUITE_P(EitherWay, Beneath,
                         testing::Values(support::open_beneath, support::open_beneath_by_names));

}  // namespace
}  // namespace fixproof
