/// @file
/// One shell command, with pipes to its input and from both of its outputs.
#pragma once

#include <boost/noncopyable.hpp>
#include <optional>
#include <string>

#include "support/descriptor.hpp"

namespace fixproof::program {

/// A command of /bin/sh in a process group of its own, which Ctrl-C does not reach. The whole group
/// ends with this object.
class Child : private boost::noncopyable {
 public:
  /// @throws std::system_error if it cannot be started
  explicit Child(const std::string& command);
  ~Child();

  /// The ends of the pipes here. They never block.
  support::Descriptor in;
  support::Descriptor out;
  support::Descriptor err;

  /// Returns how the shell ended, or nothing if it has not.
  struct Ending {
    int status = 0;  ///< of the program, unless a signal ended it
    int signal = 0;  ///< 0 if none ended it
  };
  [[nodiscard]] std::optional<Ending> ending() const;

 private:
  int process_ = -1;
};

}  // namespace fixproof::program
