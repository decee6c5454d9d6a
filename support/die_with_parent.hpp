/// @file
/// Ends child processes together with this one.
#pragma once

#include <sys/types.h>

namespace fixproof::support {

/// Called in a child: makes the kernel end it when the thread that started it ends, even by
/// SIGKILL, and ends it now if `parent` is gone. It also holds for a program that the child
/// becomes. Does nothing on systems other than Linux.
void die_with_parent(pid_t parent);

}  // namespace fixproof::support
