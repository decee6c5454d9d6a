/// @file
/// Ctrl-C, and being asked to terminate.
#pragma once

#include <atomic>

namespace fixproof {

/// While it lives, the first SIGINT or SIGTERM only sets a flag; the second one kills.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt(Interrupt&&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  Interrupt& operator=(Interrupt&&) = delete;

  /// Set when a signal has come.
  [[nodiscard]] static const std::atomic<bool>& flag();
};

}  // namespace fixproof
