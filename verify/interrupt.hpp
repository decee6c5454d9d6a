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
  Interrupt& operator=(const Interrupt&) = delete;

  /// Set when a signal has come.
  [[nodiscard]] const std::atomic<bool>& flag() const;
};

}  // namespace fixproof
