/// @file
/// A stack for the handlers of signals, because code that faults may have used up or lost its own.
#pragma once

#include <signal.h>  // NOLINT(modernize-deprecated-headers): sigaltstack() is POSIX's

#include <boost/noncopyable.hpp>
#include <cerrno>
#include <cstddef>
#include <system_error>
#include <vector>

namespace fixproof::machine_code {

/// While one exists, the handlers of its thread run on it.
class HandlerStack : private boost::noncopyable {
 public:
  /// @throws std::system_error if the system refuses the stack
  HandlerStack() {
    stack_t own{};
    own.ss_sp = bytes_.data();
    own.ss_size = bytes_.size();
    if (sigaltstack(&own, &previous_) != 0) {
      throw std::system_error(errno, std::generic_category(), "sigaltstack");
    }
  }
  ~HandlerStack() { sigaltstack(&previous_, nullptr); }

 private:
  /// The largest register files of x86-64 take 11 KiB of it.
  std::vector<std::byte> bytes_ = std::vector<std::byte>(0x10000);
  stack_t previous_{};
};

}  // namespace fixproof::machine_code
