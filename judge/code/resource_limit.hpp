/// @file
/// Limits what a process may use.
#pragma once

#include <sys/resource.h>

namespace fixproof::judge {

/// Lets this process, and what it becomes, use at most so much of a resource such as RLIMIT_AS.
/// @tparam Resource int, or the enumeration of a C library
template <class Resource>
void limit(Resource resource, rlim_t most) {
  const rlimit both{most, most};
  setrlimit(resource, &both);
}

}  // namespace fixproof::judge
