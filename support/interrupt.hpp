/// @file
/// Ctrl-C, a closed terminal, and being asked to terminate.
#pragma once

#include <atomic>
#include <boost/noncopyable.hpp>

namespace fixproof::support {

/// What the shell reports of a command that Ctrl-C has ended.
inline constexpr int interrupted_status = 130;

/// While it lives, the first SIGINT, SIGTERM or SIGHUP only sets a flag. One that comes more than a
/// second later kills; sooner ones are taken for the same, since some tools signal a process and
/// its group alike.
class Interrupt : private boost::noncopyable {
 public:
  Interrupt();
  ~Interrupt();

  /// Set when a signal has come.
  [[nodiscard]] static const std::atomic<bool>& flag();
};

}  // namespace fixproof::support
