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
  system_call,  ///< it asked the system for something that it may not
  out_of_time,  ///< it took longer than allowed
  out_of_memory,
  crashed,  ///< a signal ended it
  ended,    ///< it ended by itself
};

struct Reply {
  Downfall downfall = Downfall::none;
  std::string bytes{};  ///< empty after a downfall
};

/// A copy of this process that runs `serve` for each request. On Linux it can open no file, start
/// no process and signal none: the kernel ends it if it tries (seccomp(2)), and also if it uses
/// more memory or processor time than allowed. It dies with its parent, too.
class Confined : private boost::noncopyable {
 public:
  /// @param prepare runs in the child before it is confined, and returns what serves requests
  /// @param memory  more bytes of address space than this process has now
  /// @throws std::system_error if the system provides no process
  using Serve = std::function<std::string(std::string_view request)>;
  /// What both processes see: the steps that are done for the current request.
  using Steps = std::atomic<std::uint64_t>;
  Confined(const std::function<Serve(Steps& steps)>& prepare, std::size_t memory);
  ~Confined();

  /// Sends a request and waits for the reply, at most for `limit` without another step. After a
  /// downfall the child is gone.
  /// @throws proof::Stopped if Interrupt::flag() is set
  Reply ask(std::string_view request, std::chrono::milliseconds limit);
  [[nodiscard]] bool is_alive() const { return id_ > 0; }
  /// Returns the steps that were done for the last request.
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
