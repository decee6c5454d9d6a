/// @file
/// A file that appears under its name only when it is complete.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <string>
#include <string_view>

namespace fixproof::support {

/// Resolves symbolic links to the file that writing to `path` would change, so that links survive.
std::string behind_links(const std::string& path);

/// Writes `path`.part (or .2.part and so on) as a new file. finish() renames it, and the destructor
/// removes it otherwise. Errors name the file and the reason.
class PartFile : private boost::noncopyable {
 public:
  /// @throws std::runtime_error if the file cannot be created, or if `path` exists and is not a
  /// regular file: renaming would replace it, or it does not support seeking
  explicit PartFile(const std::string& path);
  ~PartFile();

  /// @throws std::runtime_error
  void append(std::string_view bytes);

  /// Overwrites the bytes from `offset` on. @throws std::runtime_error
  void overwrite(std::uint32_t offset, std::string_view bytes);

  /// Flushes to disk and renames. Must be the last call. @throws std::runtime_error
  void finish();

 private:
  std::string path_;    ///< as the caller gave it
  std::string target_;  ///< see behind_links()
  std::string part_;
  int descriptor_ = -1;
};

}  // namespace fixproof::support
