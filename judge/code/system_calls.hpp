/// @file
/// Limits what a confined process may ask of the system.
#pragma once

#include "judge/code/confined.hpp"

namespace fixproof::judge {

/// From now on, this process may only read from `in`, write to `out`, and make the calls that
/// `calls` allows. The kernel ends it at any other system call. Does nothing on systems other than
/// Linux.
/// @throws std::system_error if the kernel cannot filter system calls
void allow_only_computing(Calls calls, int in, int out);

}  // namespace fixproof::judge
