/// @file
/// A file that a run writes, locked from beginning to end of the run.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "support/descriptor.hpp"
#include "support/file_lock.hpp"
#include "support/part_file.hpp"
#include "support/place.hpp"

namespace fixproof::support {

/// Replaces a regular file only when its new contents are complete and on disk. Writes directly to
/// anything else, such as a device, a pipe or /dev/stdout.
class OutputFile : private boost::noncopyable {
 public:
  enum class Use { appending, overwriting };

  /// Checks that the file can be written, and locks it. Does not open a pipe yet, because closing
  /// it would signal end of file to its reader.
  /// @throws std::runtime_error naming the file and the reason: it cannot be written, another run
  /// is writing it, or it is to be overwritten but is not a regular file
  explicit OutputFile(const std::string& path, Use use = Use::appending);

  /// @throws std::runtime_error
  void append(std::string_view bytes);

  /// Overwrites the bytes from `offset` on. Only for Use::overwriting. @throws std::runtime_error
  void overwrite(std::uint32_t offset, std::string_view bytes);

  /// Makes the new contents visible. What is appended later is the next contents.
  /// @throws std::runtime_error
  void finish();

  /// Replaces the contents in one step. @throws std::runtime_error
  void replace(std::string_view contents);

 private:
  void begin();

  Place place_;
  std::optional<FileLock> lock_;  ///< of a regular file
  std::optional<PartFile> part_;
  Descriptor special_;
};

}  // namespace fixproof::support
