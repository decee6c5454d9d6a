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
};

struct Reply {
  Downfall downfall = Downfall::none;
  std::string bytes{};  ///< empty after a downfall
};

/// A copy of this process that serves requests. On Linux it cannot open a file, start a process or
/// send a signal: the kernel ends it if it tries (seccomp(2)). The kernel also limits its memory
/// and processor time, and ends it when its parent ends.
class Confined : private boost::noncopyable {
 public:
  /// Returns the reply to a request.
  using Serve = std::function<std::string(std::string_view request)>;
  /// The steps done for the current request, in memory that both processes share.
  using Steps = std::atomic<std::uint64_t>;

  /// Starts the process.
  /// @param prepare runs in the child before it is confined, and returns what serves the requests
  /// @param memory  bytes of address space that the child may have beyond those of this process
  /// @throws std::system_error if the system refuses the process, its pipes or its memory
  Confined(const std::function<Serve(Steps& steps)>& prepare, std::size_t memory);
  ~Confined();

  /// Sends a request and waits for the reply. Gives up if the child completes no step for `limit`.
  /// After a downfall the child is gone.
  /// @throws proof::Stopped if Interrupt::flag() is set
  Reply ask(std::string_view request, std::chrono::milliseconds limit);
  [[nodiscard]] bool is_alive() const { return id_ > 0; }
  /// Returns the number of steps done for the last request.
  [[nodiscard]] std::uint64_t steps() const { return *steps_; }

 private:
  Reply bury();

  Steps* steps_;
  int id_ = -1;
  bool late_ = false;
  support::Descriptor to_;
  support::Descriptor from_;
};

}  // namespace fixproof::judge
