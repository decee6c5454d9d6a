/// @file
/// The error for bad usage or input.
#pragma once

#include <stdexcept>

namespace fixproof::support {

/// The command prints the message as one line on stderr and exits with status 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace fixproof::support
