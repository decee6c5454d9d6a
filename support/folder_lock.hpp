/// @file
/// A folder that one process at a time writes into.
#pragma once

#include <boost/noncopyable.hpp>
#include <string>

namespace fixproof::support {

/// While it lives, no other process has one of the same folder. The system lets go of it when the
/// process ends, however it ends; nothing is left in the folder.
class FolderLock : private boost::noncopyable {
 public:
  /// @throws UsageError, beginning with `option`, if another process has it or the folder cannot be
  ///         opened
  FolderLock(const std::string& option, const std::string& folder);
  ~FolderLock();

 private:
  int descriptor_;
};

}  // namespace fixproof::support
