/// @file
/// What a confined process may ask of the system.
#pragma once

namespace fixproof::judge {

/// From now on the kernel ends this process at any system call but reading and writing what is
/// open, memory without a file, and its own end. Does nothing on systems other than Linux.
/// @throws std::system_error if the kernel does not filter system calls
void allow_only_computing();

/// Lets the kernel end this process when its parent ends. Does nothing on systems other than Linux.
void die_with_parent();

}  // namespace fixproof::judge
