// Target `command_line`: a whole run of `fixproof`, in this process. Each line of the input is one
// argument. After a line `--` comes standard input, and after a second one the contents of the file
// `file`. The run must end with a documented status, and with a message on one line for status 2.
// Arguments that lead out of the folder of the run are not tried, nor is `--run`, which hands its
// value to a shell. No solver is found, because no run may start a process.
#include "app/cli/command_line.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/commands.hpp"
#include "fuzz/captured_output.hpp"
#include "fuzz/control_characters.hpp"
#include "fuzz/finding.hpp"
#include "support/file.hpp"
#include "support/interrupt.hpp"
#include "tests/support/scratch_folder.hpp"

using namespace fixproof;
namespace fs = std::filesystem;

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

/// Only /dev/null lies elsewhere, alone or as the value of an option: `--out=/dev/null`.
bool stays_in_folder(const std::string& argument) {
  constexpr std::string_view null = "/dev/null";
  std::string_view rest = argument;
  if (rest == null || rest.ends_with("=/dev/null")) rest.remove_suffix(null.size());
  return rest.find('/') == std::string_view::npos && rest.find("..") == std::string_view::npos &&
         rest.find('\0') == std::string_view::npos && !rest.starts_with('~');
}

bool starts_a_shell(const std::string& argument) { return argument.starts_with("--run"); }

/// The folder of the runs.
class Folder {
 public:
  Folder() : back_(open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (back_ < 0) fuzz::report_finding("no way back to the first folder");
  }
  ~Folder() { close(back_); }
  Folder(const Folder&) = delete;
  Folder(Folder&&) = delete;
  Folder& operator=(const Folder&) = delete;
  Folder& operator=(Folder&&) = delete;

  /// Clears the folder, writes the input files and makes it the current one.
  void enter(const std::string& file) const {
    for (const auto& entry : fs::directory_iterator(scratch_.path())) fs::remove_all(entry.path());
    fs::copy_file(FIXPROOF_SCENES "/twelve_cubes.json", scratch_.path("scene.json"));
    static_cast<void>(scratch_.write("file", file));
    fs::current_path(scratch_.path());
  }
  /// Returns the name and the contents of every file.
  [[nodiscard]] std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(scratch_.path())) {
      if (!entry.is_regular_file()) continue;
      const std::string name = fs::relative(entry.path(), scratch_.path());
      all[name] = scratch_.read(name);
    }
    return all;
  }
  /// The corpus may be named relative to the folder where the program began.
  void leave() const {
    if (fchdir(back_) != 0) fuzz::report_finding("cannot leave the folder");
  }

 private:
  ScratchFolder scratch_;
  int back_;
};

// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables): handlers reach them
volatile std::sig_atomic_t interruptions = 0;
volatile std::sig_atomic_t asked_to_end = 0;
// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables)

/// Someone wants to end the target, not the command.
extern "C" void end_later(int /*signal*/) { asked_to_end = 1; }

/// Passes SIGINT to the handler of the command, once it has one. Without a handler the signal would
/// end the program. It is sent once only, because the handler ends the program at a second signal
/// more than a second later.
extern "C" void interrupt_command(int /*signal*/) {
  struct sigaction current {};
  sigaction(SIGINT, nullptr, &current);
  const bool has_own = (current.sa_flags & SA_SIGINFO) == 0 && current.sa_handler != SIG_DFL &&
                       current.sa_handler != SIG_IGN && current.sa_handler != end_later;
  if (interruptions > 0 || !has_own) return;
  interruptions = interruptions + 1;
  current.sa_handler(SIGINT);
}

/// Interrupts a command that takes long, as Ctrl-C does.
class Alarm {
 public:
  Alarm() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], nullptr, &before_[i]);
    {
      // Takes back the interruption of the run before.
      const support::Interrupt fresh;
    }
    // Handles signals while the command has no handler. SIG_IGN would lose them.
    for (std::size_t i = 0; i < signals.size(); ++i) {
      if (before_[i].sa_handler != SIG_IGN) std::signal(signals[i], end_later);
    }
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
    const bool by_others = interruptions == 0 && support::Interrupt::flag();
    if (asked_to_end != 0 || by_others) static_cast<void>(std::raise(SIGTERM));
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

struct RunResult {
  int status = 0;
  std::string out;
  std::string err;
  std::map<std::string, std::string> files;
  bool interrupted = false;
};

RunResult run(const Input& input) {
  static const Folder folder;
  folder.enter(input.file);
  std::istringstream in(input.in);
  std::ostringstream out;
  std::streambuf* const cin = std::cin.rdbuf(in.rdbuf());
  std::streambuf* const cout = std::cout.rdbuf(out.rdbuf());
  std::cin.clear();
  std::cout.clear();
  RunResult result;
  std::optional<std::string> thrown;
  {
    const Alarm alarm;
    const fuzz::CapturedOutput out_below(STDOUT_FILENO);  // `gen` writes there
    const fuzz::CapturedOutput err(STDERR_FILENO);
    try {
      result.status = cli::run_command_line(input.arguments, cli::add_all_commands);
    } catch (const std::exception& error) {
      thrown = error.what();
    }
    result.interrupted = interruptions > 0;
    result.err = err.text();
    result.out = out_below.text();
  }
  std::cin.rdbuf(cin);
  std::cout.rdbuf(cout);
  result.files = folder.files();
  folder.leave();
  if (thrown) fuzz::report_finding("thrown: " + *thrown);
  result.out += out.str();
  return result;
}

[[noreturn]] void report(const Input& input, const RunResult& result, const std::string& what) {
  std::string arguments;
  for (const std::string& one : input.arguments) arguments += fmt::format(" '{}'", one);
  constexpr std::size_t most = 2000;
  fuzz::report_finding(fmt::format("{}\n  fixproof{}\n  status {}, standard error:\n{}", what,
                                   arguments, result.status, result.err.substr(0, most)));
}

/// Whether standard output may be the bytes of a program: `dos` writes one unless it is a terminal.
bool may_write_a_program(const Input& input) {
  return !input.arguments.empty() && input.arguments.front() == "dos";
}

void check_result(const Input& input, const RunResult& result) {
  const int status = result.status;
  if (status != 0 && status != 1 && status != 2 && status != support::interrupted_status) {
    report(input, result, "a status that is not documented");
  }
  if (status == support::interrupted_status && !result.interrupted) {
    report(input, result, "interrupted without an interruption");
  }
  if (fuzz::has_control_character(result.err)) {
    report(input, result, "a control character on standard error");
  }
  if (fuzz::has_control_character(result.out) && !may_write_a_program(input)) {
    report(input, result, "a control character on standard output");
  }
  if (status != 2) return;
  const std::string_view all = result.err;
  if (!all.ends_with('\n')) report(input, result, "a refusal without a message");
  const std::size_t before = all.rfind('\n', all.size() - 2);
  const std::string_view last = before == std::string_view::npos ? all : all.substr(before + 1);
  constexpr std::string_view begin = "fixproof: ";
  if (!last.starts_with(begin) || last.size() < begin.size() + 3) {
    report(input, result, "the last line is not a message");
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
  if (std::any_of(input.arguments.begin(), input.arguments.end(), starts_a_shell)) return 0;
  const RunResult once = run(input);
  check_result(input, once);
  if (!is_repeatable(input) || once.interrupted) return 0;
  const RunResult again = run(input);
  check_result(input, again);
  if (again.interrupted) return 0;
  if (again.status != once.status || again.out != once.out || again.err != once.err ||
      again.files != once.files) {
    report(input, again, "run again, it ends otherwise");
  }
  return 0;
}
