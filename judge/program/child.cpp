#include "judge/program/child.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "support/die_with_parent.hpp"

namespace fixproof::program {

namespace {

struct Pipe {
  support::Descriptor read;
  support::Descriptor write;
};

[[noreturn]] void refuse(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// Makes a pipe that no other child inherits.
Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) refuse("cannot make a pipe");
  return {support::Descriptor(ends[0]), support::Descriptor(ends[1])};
}

void never_block(const support::Descriptor& end) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the only function there is
  if (::fcntl(end.number(), F_SETFL, O_NONBLOCK) != 0) refuse("cannot prepare a pipe");
}

/// Becomes the command. Only what is safe after a fork of any process is called.
[[noreturn]] void become(std::array<char*, 4> arguments, pid_t parent, int in, int out, int err) {
  ::setpgid(0, 0);
  support::die_with_parent(parent);
  // Programs of a pipe end by this signal once nothing reads what they write.
  static_cast<void>(std::signal(SIGPIPE, SIG_DFL));
  if (::dup2(in, STDIN_FILENO) >= 0 && ::dup2(out, STDOUT_FILENO) >= 0 &&
      ::dup2(err, STDERR_FILENO) >= 0) {
    ::execv("/bin/sh", arguments.data());
  }
  constexpr int cannot_run = 126;  // as the shell reports it
  ::_exit(cannot_run);
}

}  // namespace

Child::Child(const std::string& command) {
  // A program that no longer reads is an answer, not this process's end.
  static_cast<void>(std::signal(SIGPIPE, SIG_IGN));
  Pipe input = make_pipe();
  Pipe output = make_pipe();
  Pipe errors = make_pipe();
  never_block(input.write);
  never_block(output.read);
  never_block(errors.read);
  std::string shell = "sh";
  std::string option = "-c";
  std::string text = command;
  const std::array<char*, 4> arguments{shell.data(), option.data(), text.data(), nullptr};
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) refuse("cannot start a process");
  if (process_ == 0) {
    become(arguments, parent, input.read.number(), output.write.number(), errors.write.number());
  }
  ::setpgid(process_, process_);  // also here: either may come first
  in = std::move(input.write);
  out = std::move(output.read);
  err = std::move(errors.read);
}

Child::~Child() {
  // The process still has its number, because nothing has waited for it.
  ::kill(-process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

std::optional<Child::Ending> Child::ending() const {
  siginfo_t info{};
  if (::waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
      info.si_pid == 0) {
    return std::nullopt;
  }
  if (info.si_code != CLD_EXITED) return Ending{.signal = info.si_status};
  // A shell says so of a program that a signal ended.
  constexpr int of_signals = 128;
  if (info.si_status > of_signals && info.si_status < of_signals + SIGRTMIN) {
    return Ending{.signal = info.si_status - of_signals};
  }
  return Ending{.status = info.si_status};
}

}  // namespace fixproof::program
