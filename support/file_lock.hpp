/// @file
/// Locks a file against a second run that would write it.
#pragma once

#include <boost/noncopyable.hpp>
#include <string>
#include <string_view>

#include "support/descriptor.hpp"
#include "support/place.hpp"

namespace fixproof::support {

/// The ending of an unfinished file, which stands beside the file that it will replace.
inline constexpr std::string_view part_ending = ".fixproof-part";

/// Holds an exclusive lock on a place while a run writes it: a lock on the file NAME.fixproof-lock
/// beside it, because every replacement makes NAME another file. The system releases the lock when
/// the process ends in any way. The next run takes over a lock file and removes the unfinished file
/// of a killed run.
class FileLock : private boost::noncopyable {
 public:
  /// @param place must outlive the lock
  /// @throws std::runtime_error if another run holds the lock or no lock file can be made
  explicit FileLock(const Place& place);
  ~FileLock();

 private:
  const Place& place_;
  std::string name_;
  Descriptor file_;
};

/// Removes from a folder what killed runs have left there. Leaves the files of live runs, and
/// those of a name that is a link.
void remove_leftovers(const std::string& folder);

}  // namespace fixproof::support
