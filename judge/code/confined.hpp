/// @file
/// A child process that serves requests and can do nothing else.
#pragma once

#include <atomic>
#include <boost/noncopyable.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "support/descriptor.hpp"

namespace fixproof::judge {

/// Why a confined process did not reply.
enum class Downfall {
  none,
  system_call,    ///< it made a forbidden system call
  out_of_time,    ///< it exceeded its time limit
  out_of_memory,  ///< it exceeded its memory limit
  crashed,        ///< a signal ended it
  ended,          ///< it exited by itself
  false_reply,    ///< it wrote what is no reply
};

struct Reply {
  Downfall downfall = Downfall::none;
  std::string bytes{};  ///< empty after a downfall
};

/// What a request may take.
struct Allowance {
  std::chrono::milliseconds step{};   ///< time without a completed step
  std::chrono::milliseconds whole{};  ///< time for all of it
  std::uint64_t steps = 0;            ///< a higher count of steps is false and does not count
  std::size_t bytes = 0;              ///< length of the reply
};

/// Answers requests. Its replies may be hostile: check every byte.
class Server : private boost::noncopyable {
 public:
  virtual ~Server() = default;

  /// Sends a request and waits for the reply. After a downfall no request is answered.
  /// @throws support::Stopped if Interrupt::flag() is set
  virtual Reply ask(std::string_view request, const Allowance& allowance) = 0;
  [[nodiscard]] virtual bool is_alive() const = 0;
  /// Returns the number of steps that the server claims to have done for the last request.
  [[nodiscard]] virtual std::uint64_t steps() const = 0;
};

/// What a confined process may ask the kernel for, besides using its two pipes, ending, returning
/// from a signal handler, and anonymous memory without execution.
enum class Calls {
  fewest,    ///< nothing. It cannot read the processor's clock, either
  emulator,  ///< what Unicorn needs: locks, signals, the time, random bytes, memory for code
};

/// A copy of this process that serves requests. On Linux it cannot open a file, start a process or
/// send a signal: the kernel ends it if it tries (seccomp(2)). The kernel also limits its memory
/// and processor time, and ends it when its parent ends.
class Confined final : public Server {
 public:
  /// Returns the reply to a request.
  using Serve = std::function<std::string(std::string_view request)>;
  /// The steps done for the current request, in memory that both processes share.
  using Steps = std::atomic<std::uint64_t>;

  /// Starts the process.
  /// @param prepare runs in the child before it is confined, and returns what serves the requests
  /// @param memory  bytes of address space that the child may have beyond those of this process
  /// @throws std::system_error if the system refuses the process, its pipes or its memory
  Confined(const std::function<Serve(Steps& steps)>& prepare, std::size_t memory, Calls calls);
  ~Confined() override;

  Reply ask(std::string_view request, const Allowance& allowance) override;
  [[nodiscard]] bool is_alive() const override { return id_ > 0; }
  [[nodiscard]] std::uint64_t steps() const override { return *steps_; }

 private:
  /// Returns why the child is gone; `reason` if that is known.
  Reply bury(Downfall reason = Downfall::none);

  Steps* steps_;
  int id_ = -1;
  support::Descriptor to_;
  support::Descriptor from_;
};

}  // namespace fixproof::judge
