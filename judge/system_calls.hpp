/// @file
/// Limits what a confined process may ask of the system.
#pragma once

namespace fixproof::judge {

/// From now on, this process may only read and write what is open, allocate memory, read the clock
/// and random bytes, change its signal mask, wait, and exit. The kernel ends it at any other system
/// call. Does nothing on systems other than Linux.
/// @throws std::system_error if the kernel cannot filter system calls
void allow_only_computing();

/// Makes the kernel end this process when its parent ends. Does nothing on systems other than
/// Linux.
void die_with_parent();

}  // namespace fixproof::judge
