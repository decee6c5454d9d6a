/// @file
/// A file that appears under its name only when it is complete.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <string>
#include <string_view>

#include "support/descriptor.hpp"
#include "support/place.hpp"

namespace fixproof::support {

/// Writes NAME.fixproof-part as a new file with the owner and the mode of the file that it will
/// replace. finish() renames it, and the destructor removes it otherwise. The caller holds the
/// FileLock of the place. Errors name the file and the reason.
class PartFile : private boost::noncopyable {
 public:
  /// @param place must outlive the part
  /// @throws std::runtime_error if the file cannot be created or the owner and mode not be kept
  explicit PartFile(const Place& place);
  ~PartFile();

  /// @throws std::runtime_error
  void append(std::string_view bytes);

  /// Overwrites the bytes from `offset` on. @throws std::runtime_error
  void overwrite(std::uint32_t offset, std::string_view bytes);

  /// Flushes to disk, renames, and flushes the folder. Must be the last call.
  /// @throws std::runtime_error
  void finish();

 private:
  void keep_owner_and_mode(const struct stat& old);
  void check(int error) const;

  const Place& place_;
  std::string name_;
  Descriptor file_;
  bool is_ours_ = false;  ///< whether the destructor removes the file
};

}  // namespace fixproof::support
