/// @file
/// Calls of native code that may fault.
#pragma once

#include <functional>

namespace fixproof::machine_code {

/// Calls `body`. Returns 0, or the signal of the fault that ended it: SIGFPE for an integer divide
/// by zero, SIGSEGV for memory that is not there or a stack without end. A fault leaves `body` at
/// once and runs no destructors in it. Several threads may call this at once, but calls must not
/// nest.
/// @throws std::system_error if the system provides no handlers, and what `body` throws
int signal_of(const std::function<void()>& body);

}  // namespace fixproof::machine_code
