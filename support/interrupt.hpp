/// @file
/// Handles SIGINT (Ctrl-C), SIGTERM and SIGHUP.
#pragma once

#include <atomic>
#include <boost/noncopyable.hpp>
#include <stdexcept>

namespace fixproof::support {

/// The status that the shell reports for a command ended by Ctrl-C.
inline constexpr int interrupted_status = 130;

/// During its lifetime the first SIGINT, SIGTERM or SIGHUP only sets a flag. A signal more than a
/// second later kills the process. Earlier ones count as the same signal, because some tools signal
/// both a process and its group.
class Interrupt : private boost::noncopyable {
 public:
  Interrupt();
  ~Interrupt();

  /// Set by the first signal.
  [[nodiscard]] static const std::atomic<bool>& flag();
};

/// Interrupt::flag() was set, so there is no result.
class Stopped : public std::runtime_error {
 public:
  Stopped() : std::runtime_error("stopped") {}
};

}  // namespace fixproof::support
