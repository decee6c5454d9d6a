// Target `command_line`: a whole run of `fixproof`, in this process. Each line of the input is one
// argument. After a line `--` comes standard input, and after a second one the contents of the file
// `file`. The run must end with a documented status, and with a message on one line for status 2.
// Arguments that lead out of the folder of the run are not tried. No solver is found, because no
// run may start a process.
#include "cli/command_line.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/finding.hpp"
#include "support/file.hpp"
#include "support/interrupt.hpp"

using namespace fixproof;
namespace fs = std::filesystem;

// A sanitizer writes to this descriptor, wherever standard error leads.
extern "C" __attribute__((weak)) void __sanitizer_set_report_fd(void* descriptor);

namespace {

struct Input {
  std::vector<std::string> arguments;
  std::string in;
  std::string file;
};

/// Cuts `text` at its first line `--`, which belongs to neither part.
std::string take_part(std::string& text) {
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (std::string_view(text).substr(begin, end - begin) == "--") {
      std::string part = text.substr(0, begin);
      text.erase(0, std::min(end + 1, text.size()));
      return part;
    }
    begin = end + 1;
  }
  return std::exchange(text, {});
}

Input read_input(std::string text) {
  Input input;
  std::istringstream arguments(take_part(text));
  for (std::string one; std::getline(arguments, one);) input.arguments.push_back(one);
  input.in = take_part(text);
  input.file = std::move(text);
  return input;
}

bool stays_in_folder(const std::string& argument) {
  const bool is_null = argument == "/dev/null" || argument.ends_with("=/dev/null");
  return (is_null || argument.find('/') == std::string::npos) &&
         argument.find("..") == std::string::npos && !argument.starts_with('~') &&
         argument.find('\0') == std::string::npos;
}

/// The folder of the runs. enter() clears it and writes the input files; the destructor removes it.
class Folder {
 public:
  Folder() : back_(open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    std::string name = fs::temp_directory_path() / "fixproof-fuzz-XXXXXX";
    if (back_ < 0 || mkdtemp(name.data()) == nullptr) fuzz::report_finding("no folder to work in");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    close(back_);
  }
  Folder(const Folder&) = delete;
  Folder(Folder&&) = delete;
  Folder& operator=(const Folder&) = delete;
  Folder& operator=(Folder&&) = delete;

  void enter(const std::string& file) const {
    for (const auto& entry : fs::directory_iterator(path_)) fs::remove_all(entry.path());
    fs::copy_file(FIXPROOF_SCENES "/twelve_cubes.json", path_ / "scene.json");
    std::ofstream(path_ / "file", std::ios::binary) << file;
    fs::current_path(path_);
  }
  /// The corpus may be named relative to the folder where the program began.
  void leave() const {
    if (fchdir(back_) != 0) fuzz::report_finding("cannot leave the folder");
  }

 private:
  int back_;
  fs::path path_;
};

using Handler = void (*)(int);

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a handler reaches it
volatile std::sig_atomic_t interruptions = 0;

/// Passes SIGINT to the handler of the command, once it has one. Without a handler the signal would
/// end the program. It is sent once only, because the handler ends the program at a second signal
/// more than a second later.
extern "C" void interrupt_command(int /*signal*/) {
  struct sigaction current {};
  sigaction(SIGINT, nullptr, &current);
  const bool has_own = (current.sa_flags & SA_SIGINFO) == 0 && current.sa_handler != SIG_DFL &&
                       current.sa_handler != SIG_IGN;
  if (interruptions > 0 || !has_own) return;
  interruptions = interruptions + 1;
  current.sa_handler(SIGINT);
}

/// Interrupts a command that takes long, as Ctrl-C does.
class Alarm {
 public:
  Alarm() {
    for (std::size_t i = 0; i < signals.size(); ++i) {
      sigaction(signals[i], nullptr, &before_[i]);
      std::signal(signals[i], SIG_IGN);
    }
    {
      // Takes back the interruption of the run before.
      const support::Interrupt fresh;
    }
    for (const int signal : signals) std::signal(signal, SIG_IGN);
    interruptions = 0;
    struct sigaction action {};
    action.sa_handler = interrupt_command;
    action.sa_flags = SA_RESTART;
    sigaction(SIGUSR2, &action, nullptr);
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = SIGUSR2;
    if (timer_create(CLOCK_MONOTONIC, &event, &timer_) != 0) fuzz::report_finding("no timer");
    constexpr timespec pause{0, 30'000'000};
    const itimerspec every{pause, pause};
    timer_settime(timer_, 0, &every, nullptr);
  }
  ~Alarm() {
    timer_delete(timer_);
    std::signal(SIGUSR2, SIG_IGN);
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
  }
  Alarm(const Alarm&) = delete;
  Alarm(Alarm&&) = delete;
  Alarm& operator=(const Alarm&) = delete;
  Alarm& operator=(Alarm&&) = delete;

 private:
  static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, signals.size()> before_{};
  timer_t timer_{};
};

/// Sends standard error to a file in memory.
class ErrorOutput {
 public:
  ErrorOutput() : before_(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
    file_ = memfd_create("stderr", MFD_CLOEXEC);
    if (before_ < 0 || file_ < 0) fuzz::report_finding("no file in memory");
    if (__sanitizer_set_report_fd != nullptr) set_report(before_);
    std::fflush(stderr);
    dup2(file_, STDERR_FILENO);
  }
  ~ErrorOutput() {
    close(file_);
    close(before_);
  }
  ErrorOutput(const ErrorOutput&) = delete;
  ErrorOutput(ErrorOutput&&) = delete;
  ErrorOutput& operator=(const ErrorOutput&) = delete;
  ErrorOutput& operator=(ErrorOutput&&) = delete;

  /// Ends it.
  std::string text() const {
    std::fflush(stderr);
    dup2(before_, STDERR_FILENO);
    if (__sanitizer_set_report_fd != nullptr) set_report(STDERR_FILENO);
    std::string text;
    std::array<char, 4096> part{};
    for (off_t at = 0;;) {
      const ssize_t count = pread(file_, part.data(), part.size(), at);
      if (count <= 0) return text;
      text.append(part.data(), static_cast<std::size_t>(count));
      at += count;
    }
  }

 private:
  static void set_report(int descriptor) {
    // NOLINTNEXTLINE(*-reinterpret-cast,performance-no-int-to-ptr): the interface of sanitizers
    __sanitizer_set_report_fd(reinterpret_cast<void*>(static_cast<std::intptr_t>(descriptor)));
  }

  int before_;
  int file_ = -1;
};

struct Ending {
  int status = 0;
  std::string out;
  std::string err;
  bool interrupted = false;
};

Ending run(const Input& input) {
  static const Folder folder;
  folder.enter(input.file);
  std::istringstream in(input.in);
  std::ostringstream out;
  std::streambuf* const cin = std::cin.rdbuf(in.rdbuf());
  std::streambuf* const cout = std::cout.rdbuf(out.rdbuf());
  std::cin.clear();
  std::cout.clear();
  Ending ending;
  std::optional<std::string> thrown;
  {
    const ErrorOutput err;
    const Alarm alarm;
    try {
      ending.status = cli::run_command_line(input.arguments);
    } catch (const std::exception& error) {
      thrown = error.what();
    }
    ending.interrupted = interruptions > 0;
    ending.err = err.text();
  }
  std::cin.rdbuf(cin);
  std::cout.rdbuf(cout);
  folder.leave();
  if (thrown) fuzz::report_finding("thrown: " + *thrown);
  ending.out = out.str();
  return ending;
}

[[noreturn]] void report(const Input& input, const Ending& ending, const std::string& what) {
  std::string arguments;
  for (const std::string& one : input.arguments) arguments += fmt::format(" '{}'", one);
  constexpr std::size_t most = 2000;
  fuzz::report_finding(fmt::format("{}\n  fixproof{}\n  status {}, standard error:\n{}", what,
                                   arguments, ending.status, ending.err.substr(0, most)));
}

void check_ending(const Input& input, const Ending& ending) {
  const int status = ending.status;
  if (status != 0 && status != 1 && status != 2 && status != support::interrupted_status) {
    report(input, ending, "a status that is not documented");
  }
  if (status == support::interrupted_status && !ending.interrupted) {
    report(input, ending, "interrupted without an interruption");
  }
  if (std::any_of(ending.err.begin(), ending.err.end(), [](char c) {
        return (static_cast<unsigned char>(c) < ' ' && c != '\n') || c == '\x7f';
      })) {
    report(input, ending, "a control character on standard error");
  }
  if (status != 2) return;
  const std::string_view all = ending.err;
  if (!all.ends_with('\n')) report(input, ending, "a refusal without a message");
  const std::size_t before = all.rfind('\n', all.size() - 2);
  const std::string_view last = before == std::string_view::npos ? all : all.substr(before + 1);
  constexpr std::string_view begin = "fixproof: ";
  if (!last.starts_with(begin) || last.size() < begin.size() + 3) {
    report(input, ending, "the last line is not a message");
  }
}

/// Whether its output depends on nothing but the arguments and the files.
bool is_repeatable(const Input& input) {
  static constexpr std::array<std::string_view, 9> commands{
      "eval", "step", "check", "gen", "list", "trace", "dos", "merge", "--help"};
  return input.arguments.empty() ||
         std::find(commands.begin(), commands.end(), input.arguments.front()) != commands.end();
}

void prepare() {
  // Solvers are not found here, and no window can be opened.
  setenv("PATH", "/nonexistent", 1);
  setenv("SDL_VIDEODRIVER", "none", 1);
  setenv("SDL_AUDIODRIVER", "none", 1);
  std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool prepared = (prepare(), true);
  static_cast<void>(prepared);
  const Input input = read_input(std::string(data, data + size));
  if (!std::all_of(input.arguments.begin(), input.arguments.end(), stays_in_folder)) return 0;
  const Ending once = run(input);
  check_ending(input, once);
  if (!is_repeatable(input) || once.interrupted) return 0;
  const Ending again = run(input);
  check_ending(input, again);
  if (again.interrupted) return 0;
  if (again.status != once.status || again.out != once.out || again.err != once.err) {
    report(input, again, "run again, it ends otherwise");
  }
  return 0;
}
