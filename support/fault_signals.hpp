/// @file
/// Handlers of the signals that faults of this process raise.
#pragma once

#include <signal.h>  // NOLINT(modernize-deprecated-headers): siginfo_t is POSIX's

namespace fixproof::support {

/// Handles the fault if it came from the code that it watches. Runs in a signal handler, on the
/// alternate stack if the thread has one.
/// @return false to leave the fault to others
using FaultHandler = bool (*)(int signal, void* context);

/// Calls `handler` for every SIGFPE, SIGSEGV, SIGBUS, SIGILL and SIGTRAP of any thread from now on.
/// Later handlers come first. A fault that no handler takes goes to the action that the process had
/// before. Adding a handler again does nothing.
/// @throws std::system_error if the system rejects it, std::length_error beyond four handlers
void add_fault_handler(FaultHandler handler);

}  // namespace fixproof::support
