/// @file
/// Locks a folder so that only one process at a time writes into it.
#pragma once

#include <boost/noncopyable.hpp>
#include <string>

#include "support/descriptor.hpp"

namespace fixproof::support {

/// Holds an exclusive lock on a folder. The system releases it when the process ends in any way,
/// and leaves no file behind.
class FolderLock : private boost::noncopyable {
 public:
  /// @throws UsageError, beginning with `option`, if another process holds the lock or the folder
  /// cannot be opened; std::runtime_error if Place refuses it
  FolderLock(const std::string& option, const std::string& folder);

 private:
  Descriptor folder_;
};

}  // namespace fixproof::support
