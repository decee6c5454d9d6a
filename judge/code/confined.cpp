#include "judge/code/confined.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>  // NOLINT(modernize-deprecated-headers): kill() is POSIX's
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <fstream>
#include <new>
#include <system_error>
#include <utility>

#include "judge/code/message.hpp"
#include "judge/code/resource_limit.hpp"
#include "judge/code/system_calls.hpp"
#include "support/die_with_parent.hpp"
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

bool send(int to, std::string_view message) {
  return write_all(to, length_of(message)) && write_all(to, message);
}

/// Sends what the pipe has room for, and removes it from `bytes`.
/// @return false if the pipe has no reader
bool send_some(int to, std::string_view& bytes) {
  const ssize_t count = ::write(to, bytes.data(), bytes.size());
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  bytes.remove_prefix(static_cast<std::size_t>(count));
  return true;
}

/// @return false at the end of the input
bool receive(int from, std::string& request) {
  std::uint32_t size = 0;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): as above
  if (!read_all(from, reinterpret_cast<char*>(&size), sizeof size)) return false;
  request.resize(size);
  return read_all(from, request.data(), size);
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

/// Closes everything except the two pipes.
void close_others(int in, int out) {
  using support::close_descriptors;
  using support::Closing;
  const auto [first, second] = std::minmax({static_cast<unsigned>(in), static_cast<unsigned>(out)});
  // A pipe has the number 0 if this process was started without descriptors.
  if (first > 0) close_descriptors(0, first - 1, Closing::now);
  if (second - first > 1) close_descriptors(first + 1, second - 1, Closing::now);
  close_descriptors(second + 1, ~0U, Closing::now);
}

[[noreturn]] void serve_all(const std::function<Confined::Serve(Confined::Steps&)>& prepare,
                            Confined::Steps& steps, std::size_t memory, Calls calls, int in,
                            int out) {
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
    allow_only_computing(calls, in, out);
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

Confined::Confined(const std::function<Serve(Steps& steps)>& prepare, std::size_t memory,
                   Calls calls) {
  void* const shared =
      mmap(nullptr, sizeof(Steps), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) throw refused("mmap");
  // NOLINTNEXTLINE(cppcoreguidelines-owning-memory): the memory is the mapping's
  steps_ = new (shared) Steps(0);
  auto [request_in, request_out] = make_pipe();
  auto [reply_in, reply_out] = make_pipe();
  (void)::signal(SIGPIPE, SIG_IGN);  // a dead child is a downfall, not this process's end
  const pid_t parent = getpid();
  id_ = fork();
  if (id_ < 0) throw refused("fork");
  if (id_ == 0) {
    support::die_with_parent(parent);
    serve_all(prepare, *steps_, memory, calls, request_in.number(), reply_out.number());
  }
  to_ = std::move(request_out);
  from_ = std::move(reply_in);
  // The child may leave its end of a pipe alone for ever. This process waits for both at once.
  for (const int pipe : {to_.number(), from_.number()}) fcntl(pipe, F_SETFL, O_NONBLOCK);
}

Confined::~Confined() {
  if (is_alive()) bury();
  munmap(steps_, sizeof(Steps));
}

Reply Confined::ask(std::string_view request, const Allowance& allowance) {
  if (!is_alive()) return {Downfall::ended};
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + allowance.whole;
  auto latest = Clock::now() + allowance.step;
  std::uint64_t seen = *steps_ = 0;
  const std::string sent = length_of(request) + std::string(request);
  std::string_view unsent = sent;
  IncomingMessage reply(allowance.bytes);
  while (true) {
    std::array<pollfd, 2> waits{
        {{from_.number(), POLLIN, 0}, {unsent.empty() ? -1 : to_.number(), POLLOUT, 0}}};
    constexpr int poll_interval = 50;  // milliseconds until Ctrl-C is noticed
    poll(waits.data(), waits.size(), poll_interval);
    if (support::Interrupt::flag()) {
      bury();
      throw support::Stopped();
    }
    if (waits[1].revents != 0 && !send_some(to_.number(), unsent)) return bury();
    if (waits[0].revents != 0) {
      std::array<char, 0x10000> room{};
      const ssize_t count = ::read(from_.number(), room.data(), room.size());
      if (count == 0) return bury();
      if (count > 0) reply.add({room.data(), static_cast<std::size_t>(count)});
      const auto state = reply.state();
      const bool is_whole = state == IncomingMessage::State::whole;
      if (state == IncomingMessage::State::false_length || (is_whole && !unsent.empty())) {
        return bury(Downfall::false_reply);
      }
      if (is_whole) return {.bytes = reply.take()};
    }
    const auto now = Clock::now();
    if (const std::uint64_t done = *steps_; done > seen && done <= allowance.steps) {
      seen = done;
      latest = now + allowance.step;
    }
    if (now >= latest || now >= end) return bury(Downfall::out_of_time);
  }
}

Reply Confined::bury(Downfall reason) {
  // A child that has closed its pipes is ending: its status is fixed. Any other child ends now.
  kill(id_, SIGKILL);
  to_ = support::Descriptor();
  from_ = support::Descriptor();
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  if (reason != Downfall::none) return {reason};
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
