/// @file
/// What the user can mend.
#pragma once

#include <stdexcept>

namespace fixproof::support {

/// Bad usage or input: one line for stderr, and exit status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace fixproof::support
