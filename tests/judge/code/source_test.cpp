// NASM sources that are hostile, or in unusual places.
#include <fmt/format.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill() is POSIX's
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "judge/code/tool.hpp"
#include "tests/judge/code/judged.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

namespace fs = std::filesystem;
using judged::expect;
using judged::in_registers;
using judged::judge;

const std::string multiply = "imul ebx\nadd eax, 0x8000\nadc edx, 0\nshrd eax, edx, 16\nret\n";

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

/// Changes an environment variable as long as it exists.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    setenv(name, value.c_str(), 1);
  }
  ~Variable() {
    if (before_) {
      setenv(name_, before_->c_str(), 1);
    } else {
      unsetenv(name_);
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(Sources, TheFolderForTemporaryFilesMayHaveAnyName) {
  const ScratchFolder folder;
  const std::string source = folder.write("mul.asm", multiply);
  for (const std::string name : {"two words", "a]b", "it's", "say \"x\"", "a;b", "%x"}) {
    const fs::path place = fs::path(source).parent_path() / name;
    fs::create_directory(place);
    const Variable temporary("TMPDIR", place.string());
    expect(judge(source, in_registers + "|--cases|1000"), 0, {"AGREES on 1,000 cases"});
    EXPECT_EQ(files_in(place), 0U) << name;
  }
}

void expect_refused(const std::string& text, const std::string& message) {
  SCOPED_TRACE(text.substr(0, 100));
  const ScratchFolder folder;
  const std::string source = folder.write("hostile.asm", text);
  const auto begun = std::chrono::steady_clock::now();
  const auto run = judge(source, in_registers + "|--cases|1000");
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(60));
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
  EXPECT_EQ(files_in(fs::path(source).parent_path()), 1U);
}

TEST(Sources, ACompilerWithoutACLibrary) {
  const ScratchFolder folder;
  const std::string source = folder.write("f.c", "#include <stdint.h>\n");
  const std::string compiler = folder.write(
      "cc.sh",
      "echo 'stdint.h:9:16: fatal error: stdint.h: No such file or directory' >&2; exit 1");
  const auto run = command::run(
      {"env", "CC=bash " + compiler, paths::command(), "judge", source, "--as", "mul"});
  command::expect_usage_error(run, "No such file or directory; add -ffreestanding to the flags");
}

TEST(Sources, UseLittleMemoryAndWriteLittle) {
  expect_refused("resb 0x7fffffff", "hostile.asm: nasm");
  expect_refused("section .text\nresb 0x1fffffff", "hostile.asm: nasm");
  std::string doubles = "%define a \"0123456789abcdef0123456789abcdef\"\n";
  for (int i = 0; i < 40; ++i) doubles += "%strcat a a, a\n";
  expect_refused(doubles, "out of memory");
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  EXPECT_LT(children.ru_maxrss, 1 << 20U) << "KiB";
}

TEST(Sources, EndInTime) { expect_refused("times 0x7fffffff db 0", "5 s of processor time"); }

void expect_unread(const std::string& text) {
  SCOPED_TRACE(text);
  const ScratchFolder folder;
  fs::create_directory(folder.path("inner"));
  const std::string source = folder.write("inner/reads.asm", text);
  folder.write("secret.bin", "secret");
  fs::create_symlink("../secret.bin", fs::path(source).parent_path() / "link");
  const auto run = judge(source, "--bits|32|--list");
  EXPECT_EQ(run.status, 2) << run.out;
  EXPECT_NE(run.err.find("a source may use the files in its folder and below"), std::string::npos)
      << run.err;
}

TEST(Sources, ReadNoFileOfAnotherFolder) {
  if (!judge::confines_tools()) GTEST_SKIP() << "this kernel has no Landlock";
  for (const char* file : {"/etc/passwd", "../secret.bin", "link", "/proc/self/maps"}) {
    expect_unread(fmt::format("incbin \"{}\"\n", file));
    expect_unread(fmt::format("%include \"{}\"\n", file));
  }
}

/// Changes the current folder as long as it exists.
class CurrentFolder {
 public:
  explicit CurrentFolder(const fs::path& folder) { fs::current_path(folder); }
  ~CurrentFolder() { fs::current_path(before_); }
  CurrentFolder(const CurrentFolder&) = delete;
  CurrentFolder& operator=(const CurrentFolder&) = delete;

 private:
  fs::path before_ = fs::current_path();
};

TEST(Sources, AreRefusedIfTheirFolderIsNotKnown) {
  const ScratchFolder folder;
  const CurrentFolder back(folder.path());
  // A path that is too long for getcwd(), so that a relative name cannot be made absolute.
  const std::string name(200, 'x');
  for (int i = 0; i < 25; ++i) {
    ASSERT_EQ(mkdir(name.c_str(), 0700), 0);
    ASSERT_EQ(chdir(name.c_str()), 0);
  }
  std::ofstream("reads.asm") << "incbin \"/etc/passwd\"\n";
  const auto run = judge("reads.asm", "--bits|32|--list");
  EXPECT_EQ(run.status, 2) << run.out;
  EXPECT_NE(run.err.find("its folder is not known"), std::string::npos) << run.err;
}

TEST(Sources, GetNoDescriptorOfTheShell) {
  const ScratchFolder folder;
  const std::string source = folder.write("reads.asm", "%include \"/dev/fd/9\"\n");
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  ASSERT_EQ(write(ends[1], "db 0x5a\n", 8), 8);
  close(ends[1]);
  ASSERT_EQ(dup2(ends[0], 9), 9);
  const auto run = judge(source, "--bits|32|--list");
  close(ends[0]);
  close(9);
  EXPECT_EQ(run.status, 2) << run.out;
}

TEST(Sources, ReadTheFilesOfTheirFolder) {
  const ScratchFolder folder;
  fs::create_directories(folder.path("inner/deep"));
  folder.write("inner/deep/round.inc", "add eax, 0x8000\nadc edx, 0\n");
  const std::string source =
      folder.write("inner/mul.asm",
                   "imul ebx\n%include \"deep/round.inc\"\nshrd eax, edx, 16\nret\n"
                   "incbin \"mul.asm\"\n");
  expect(judge(source, in_registers + "|--cases|1000"), 0, {"AGREES on 1,000 cases"});
  // The folder is that of the file to which a link leads.
  const fs::path link = fs::path(source).parent_path().parent_path() / "link.asm";
  fs::create_symlink("inner/mul.asm", link);
  expect(judge(link.string(), in_registers + "|--cases|1000"), 0, {"AGREES on 1,000 cases"});
}

TEST(Sources, WriteNoFile) {
  for (const char* directive : {"[map all victim]", "[map all ./victim]", "[list victim]"}) {
    const ScratchFolder folder;
    const std::string source = folder.write("writes.asm", std::string(directive) + "\n" + multiply);
    (void)judge(source, in_registers + "|--cases|1000");
    EXPECT_EQ(files_in(fs::path(source).parent_path()), 1U) << directive;
    EXPECT_FALSE(fs::exists("victim")) << directive;
  }
}

TEST(Sources, VariablesOfTheEnvironmentDoNotCount) {
  const ScratchFolder folder;
  const std::string source = folder.write("mul.asm", multiply);
  const std::string victim = source + ".lst";
  const Variable options("NASMENV", "-l " + victim);
  expect(judge(source, in_registers + "|--cases|1000"), 0, {"AGREES on 1,000 cases"});
  EXPECT_FALSE(fs::exists(victim));
  // This is not the product if the variable is there.
  expect(judge(folder.write("home.asm", "%ifenv HOME\nret\n%endif\n" + multiply),
               in_registers + "|--cases|1000"),
         0, {"AGREES on 1,000 cases"});
}

/// Kills judge with SIGKILL while it works on the source, and expects no process of its group left.
void expect_nothing_left(const std::string& text) {
  SCOPED_TRACE(text);
  const ScratchFolder folder;
  const std::string source = folder.write("long.asm", text);
  const fs::path temporary = fs::path(source).parent_path() / "temporary";
  fs::create_directory(temporary);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    // A session cannot be left, so its number finds all processes that are begun in it.
    setsid();
    setenv("TMPDIR", temporary.c_str(), 1);
    execl(paths::command().c_str(), "fixproof", "judge", source.c_str(), "--as", "mul", nullptr);
    _exit(127);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  const auto is_left = [child] {
    for (const auto& entry : fs::directory_iterator("/proc")) {
      std::ifstream stat(entry.path() / "stat");
      std::string line;
      std::getline(stat, line);
      const std::size_t name_end = line.rfind(')');
      if (name_end == std::string::npos) continue;
      std::istringstream fields(line.substr(name_end + 1));
      std::string state;
      long parent = 0;
      long group = 0;
      long session = 0;
      if (fields >> state >> parent >> group >> session && session == child && state != "Z") {
        return true;
      }
    }
    return false;
  };
  bool left = true;
  for (int tries = 0; tries < 100 && left; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    left = is_left();
  }
  EXPECT_FALSE(left);
  EXPECT_EQ(files_in(temporary), 0U);
}

TEST(Sources, AKilledJudgeLeavesNoProcessAndNoFile) {
  expect_nothing_left("times 0x7fffffff db 0");  // nasm
  expect_nothing_left("jmp $");                  // the routine
}

}  // namespace
