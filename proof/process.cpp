#include "proof/process.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>

#include "support/interrupt.hpp"

namespace fixproof::proof {

namespace {

using Clock = std::chrono::steady_clock;
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Files without a name: whatever ends this program, nothing stays behind.
File nameless_file() {
  File file(std::tmpfile(), std::fclose);
  if (!file) {
    throw std::runtime_error(
        fmt::format("no temporary file: {}", std::generic_category().message(errno)));
  }
  return file;
}

File file_with(const std::string& text) {
  File file = nameless_file();
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0) {
    throw std::runtime_error("cannot write a temporary file");
  }
  std::rewind(file.get());
  return file;
}

std::string contents(std::FILE* file) {
  std::string text;
  std::array<char, 4096> buffer{};
  std::rewind(file);
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), file)) {
    text.append(buffer.data(), got);
  }
  return text;
}

/// Starts a program in a process group of its own: Ctrl-C is then for this program alone to answer,
/// and what a script has started ends with it.
pid_t start(std::vector<std::string>& arguments, std::FILE* in, std::FILE* out, std::FILE* err) {
  std::vector<char*> words;
  for (std::string& word : arguments) words.push_back(word.data());
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(out), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(err), STDERR_FILENO);
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int error =
      ::posix_spawnp(&process, words.front(), &actions, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), arguments.front());
  return process;
}

/// Whether a process has come to its end; `options` as for waitpid(2).
bool has_ended(pid_t process, int& status, int options) {
  while (true) {
    const pid_t ended = ::waitpid(process, &status, options);
    if (ended >= 0) return ended == process;
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  }
}

/// How a process ended by itself; nothing where it had to be ended. It is looked at again and
/// again: signals may reach any thread, so no wait would end by one.
std::optional<int> end_of(pid_t process, Clock::time_point latest) {
  constexpr std::chrono::milliseconds between_looks{1};
  int status = 0;
  while (!has_ended(process, status, WNOHANG)) {
    if (support::Interrupt::flag() || Clock::now() >= latest) {
      ::kill(-process, SIGKILL);
      has_ended(process, status, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(between_looks);
  }
  return status;
}

}  // namespace

Printed run_program(std::vector<std::string> arguments, const std::string& input,
                    std::chrono::milliseconds most) {
  if (support::Interrupt::flag()) throw Stopped();
  const File in = file_with(input);
  const File out = nameless_file();
  const File err = nameless_file();
  const pid_t process = start(arguments, in.get(), out.get(), err.get());
  const auto status = end_of(process, Clock::now() + most);
  if (!status && support::Interrupt::flag()) throw Stopped();
  if (status && WIFSIGNALED(*status)) {
    throw std::runtime_error(
        fmt::format("{} was ended by signal {}", arguments.front(), WTERMSIG(*status)));
  }
  return {.out = contents(out.get()),
          .err = contents(err.get()),
          .status = status ? WEXITSTATUS(*status) : 0,
          .in_time = status.has_value()};
}

}  // namespace fixproof::proof
