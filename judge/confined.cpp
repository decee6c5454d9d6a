#include "judge/confined.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill() is POSIX's
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <new>
#include <system_error>
#include <utility>

#include "judge/system_calls.hpp"
#include "proof/process.hpp"
#include "support/interrupt.hpp"

namespace fixproof::judge {

namespace {

constexpr int status_out_of_memory = 3;
constexpr rlim_t seconds_of_processor = 3600;

std::system_error refused(const char* what) { return {errno, std::generic_category(), what}; }

bool write_all(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(to, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

bool read_all(int from, char* to, std::size_t size) {
  while (size > 0) {
    const ssize_t count = ::read(from, to, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    to += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

/// Sends a message: its length in 4 bytes of this machine's order, then its bytes.
bool send(int to, std::string_view message) {
  const auto size = static_cast<std::uint32_t>(message.size());
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the bytes of a number
  return write_all(to, {reinterpret_cast<const char*>(&size), sizeof size}) &&
         write_all(to, message);
}

/// The longest message. A damaged length must not exhaust the memory of this process.
constexpr std::uint32_t longest = 1U << 26U;

bool receive(int from, std::string& message) {
  std::uint32_t size = 0;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): as above
  if (!read_all(from, reinterpret_cast<char*>(&size), sizeof size) || size > longest) return false;
  message.resize(size);
  return read_all(from, message.data(), size);
}

std::pair<support::Descriptor, support::Descriptor> make_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw refused("pipe");
  return {support::Descriptor(ends[0]), support::Descriptor(ends[1])};
}

rlim_t address_space() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void limit(int resource, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

/// Closes everything except the two pipes.
void close_others(int in, int out) {
  const long most = sysconf(_SC_OPEN_MAX);
  for (int i = 0; i < (most > 0 && most < 4096 ? most : 4096); ++i) {
    if (i != in && i != out) close(i);
  }
}

[[noreturn]] void serve_all(const std::function<Confined::Serve(Confined::Steps&)>& prepare,
                            Confined::Steps& steps, std::size_t memory, int in, int out) {
  try {
    sigset_t all;
    sigfillset(&all);
    for (const int fault : {SIGFPE, SIGSEGV, SIGBUS, SIGILL, SIGTRAP, SIGSYS}) {
      sigdelset(&all, fault);
    }
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    close_others(in, out);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CPU, seconds_of_processor);
    if (const rlim_t now = address_space(); now > 0) limit(RLIMIT_AS, now + memory);
    const Confined::Serve serve = prepare(steps);
    std::string request;
    std::string reply;
    allow_only_computing();
    while (receive(in, request)) {
      reply = serve(request);
      if (!send(out, reply)) break;
    }
    _exit(0);
  } catch (const std::bad_alloc&) {
    _exit(status_out_of_memory);
  } catch (...) {
    _exit(1);
  }
}

}  // namespace

Confined::Confined(const std::function<Serve(Steps& steps)>& prepare, std::size_t memory) {
  void* const shared =
      mmap(nullptr, sizeof(Steps), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw refused("mmap");
  // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the memory is the mapping's
  steps_ = new (shared) Steps(0);
  auto [request_in, request_out] = make_pipe();
  auto [reply_in, reply_out] = make_pipe();
  (void)::signal(SIGPIPE, SIG_IGN);  // a dead child is a downfall, not this process's end
  id_ = fork();
  if (id_ < 0) throw refused("fork");
  if (id_ == 0) {
    die_with_parent();
    serve_all(prepare, *steps_, memory, request_in.number(), reply_out.number());
  }
  to_ = std::move(request_out);
  from_ = std::move(reply_in);
}

Confined::~Confined() {
  if (is_alive()) bury();
  munmap(steps_, sizeof(Steps));
}

Reply Confined::ask(std::string_view request, std::chrono::milliseconds limit) {
  if (!is_alive()) return {Downfall::ended};
  using Clock = std::chrono::steady_clock;
  auto latest = Clock::now() + limit;
  std::uint64_t seen = *steps_ = 0;
  if (!send(to_.number(), request)) return bury();
  pollfd waits{.fd = from_.number(), .events = POLLIN, .revents = 0};
  constexpr int poll_interval = 50;  // milliseconds until Ctrl-C is noticed
  while (poll(&waits, 1, poll_interval) <= 0) {
    if (support::Interrupt::flag()) {
      bury();
      throw proof::Stopped();
    }
    if (const std::uint64_t now = *steps_; now != seen) {
      seen = now;
      latest = Clock::now() + limit;
    }
    if (Clock::now() >= latest) {
      late_ = true;
      return bury();
    }
  }
  Reply reply;
  return receive(from_.number(), reply.bytes) ? reply : bury();
}

Reply Confined::bury() {
  if (late_) kill(id_, SIGKILL);
  to_ = support::Descriptor();  // a child that reads the end of its input exits
  from_ = support::Descriptor();
  int status = 0;
  for (int tries = 0; waitpid(id_, &status, WNOHANG) == 0; ++tries) {
    if (tries == 100) kill(id_, SIGKILL);
    usleep(1000);
  }
  id_ = -1;
  if (late_) return {Downfall::out_of_time};
  if (WIFEXITED(status)) {
    return {WEXITSTATUS(status) == status_out_of_memory ? Downfall::out_of_memory
                                                        : Downfall::ended};
  }
  switch (WTERMSIG(status)) {
    case SIGSYS:
      return {Downfall::system_call};
    case SIGXCPU:
      return {Downfall::out_of_time};
    default:
      return {Downfall::crashed};
  }
}

}  // namespace fixproof::judge
