#include "verify/proof/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <boost/process/args.hpp>
#include <boost/process/child.hpp>
#include <boost/process/env.hpp>
#include <boost/process/environment.hpp>
#include <boost/process/exe.hpp>
#include <boost/process/extend.hpp>
#include <boost/process/group.hpp>
#include <boost/process/io.hpp>
#include <boost/process/search_path.hpp>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>

#include "support/die_with_parent.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"

namespace fixproof::proof {

namespace {

namespace bp = boost::process;
using Clock = std::chrono::steady_clock;
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The folder for temporary files. @throws std::runtime_error if there is none; std::system_error
/// would mean that the program cannot be started
std::filesystem::path temporary_folder() {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (!error) return folder;
  const char* const named = std::getenv("TMPDIR");
  throw std::runtime_error(fmt::format("TMPDIR names no folder for temporary files: {}: {}",
                                       support::quoted(named == nullptr ? "" : named),
                                       error.message()));
}

[[noreturn]] void refuse_temporary(int error) {
  throw std::runtime_error(fmt::format("cannot write a temporary file in {}: {}",
                                       temporary_folder().string(),
                                       std::generic_category().message(error)));
}

/// Reserves room for what a program says. On a full disk that would be lost, without an error here.
void reserve_room(int descriptor) {
#ifdef __linux__
  constexpr off_t room = 1 << 16;
  // Some file systems cannot reserve.
  if (::fallocate(descriptor, FALLOC_FL_KEEP_SIZE, 0, room) != 0 && errno != EOPNOTSUPP &&
      errno != ENOSYS) {
    refuse_temporary(errno);
  }
#endif
}

/// A file in TMPDIR, which std::tmpfile() ignores. It loses its name at once, so that nothing is
/// left if this program is killed later.
File temporary_file() {
  std::string name = (temporary_folder() / "fixproof.XXXXXX").string();
  const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor >= 0) ::unlink(name.c_str());
  File file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "w+"), std::fclose);
  if (!file) {
    throw std::runtime_error(fmt::format("cannot create the temporary file {}: {}", name,
                                         std::generic_category().message(errno)));
  }
  reserve_room(descriptor);
  return file;
}

File file_with(const std::string& text) {
  File file = temporary_file();
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0) {
    refuse_temporary(errno);
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

/// This process's variables, and one for a program's memory: glibc takes this much more than is
/// asked for, and keeps it. z3 gives memory back after each question and takes it again, which was
/// half of its time.
bp::environment variables_for_programs() {
  bp::environment variables = boost::this_process::environment();
  if (variables.count("MALLOC_TOP_PAD_") == 0) variables["MALLOC_TOP_PAD_"] = "67108864";
  return variables;
}

/// Starts a program in `group`: Ctrl-C does not reach it, and terminating the group ends all its
/// children too. @throws std::system_error if it cannot be started
bp::child start(const std::vector<std::string>& arguments, bp::group& group, std::FILE* in,
                std::FILE* out, std::FILE* err, const std::function<void()>& confine) {
  const std::string& name = arguments.front();
  const auto program =
      name.find('/') == std::string::npos ? bp::search_path(name) : boost::filesystem::path(name);
  if (program.empty()) {
    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory),
                            arguments.front());
  }
  // Boost marks its error pipe close-on-exec only after creating it. A program started by another
  // thread in between would inherit the pipe, and this start would wait for that program to end.
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  const bp::environment variables = confine ? bp::environment() : variables_for_programs();
  const auto prepare = [&confine, parent = getpid()](auto& /*executor*/) {
    support::die_with_parent(parent);
    if (confine) confine();
  };
  return bp::child(bp::exe = program,
                   bp::args = std::vector(arguments.begin() + 1, arguments.end()), variables,
                   bp::std_in<in, bp::std_out> out, bp::std_err > err, group,
                   bp::extend::on_exec_setup = prepare);
}

/// Waits until the program ends, `latest` passes, or Interrupt::flag() or `cancelled` is set; then
/// it kills the group. @return whether the program ended by itself
bool wait_until(Clock::time_point latest, bp::child& program, bp::group& group,
                const std::atomic<bool>& cancelled) {
  // Boost 1.74's wait_for() forks a process that sleeps, and does not see the flag.
  constexpr std::chrono::milliseconds poll_interval{1};
  while (program.running()) {
    if (support::Interrupt::flag() || cancelled || Clock::now() >= latest) {
      group.terminate();
      program.wait();
      return false;
    }
    std::this_thread::sleep_for(poll_interval);
  }
  group.detach();
  return true;
}

}  // namespace

Output run_program(const std::vector<std::string>& arguments, const std::string& input,
                   std::chrono::milliseconds limit, const std::function<void()>& confine,
                   const std::atomic<bool>& cancelled) {
  if (support::Interrupt::flag()) throw support::Stopped();
  const File in = file_with(input);
  const File out = temporary_file();
  const File err = temporary_file();
  bp::group group;
  bp::child program = start(arguments, group, in.get(), out.get(), err.get(), confine);
  const bool in_time = wait_until(Clock::now() + limit, program, group, cancelled);
  if (!in_time && support::Interrupt::flag()) throw support::Stopped();
  const int status = program.native_exit_code();
  if (in_time && WIFSIGNALED(status)) {
    throw Killed(fmt::format("{} was ended by signal {}", arguments.front(), WTERMSIG(status)));
  }
  return {.out = contents(out.get()),
          .err = contents(err.get()),
          .status = in_time ? program.exit_code() : 0,
          .in_time = in_time};
}

}  // namespace fixproof::proof
