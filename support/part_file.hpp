/// @file
/// A file that is there when it is complete and not before.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstdint>
#include <string>
#include <string_view>

namespace fixproof::support {

/// The file that writing to `path` would change: a link itself survives.
std::string behind_links(const std::string& path);

/// Written beside its place, as a new file with `.part` (or `.2.part` and so on, if that is taken)
/// added to the name; finish() puts it there. Removed if that does not happen. Errors name the file
/// and the reason.
class PartFile : private boost::noncopyable {
 public:
  /// @throws std::runtime_error if it cannot be written there, or if what is there is no regular
  ///         file (which the new one would replace, or which cannot be gone back in)
  explicit PartFile(const std::string& path);
  ~PartFile();

  /// At the end.
  /// @throws std::runtime_error
  void append(std::string_view bytes);

  /// Over what is `offset` bytes from the beginning.
  /// @throws std::runtime_error
  void overwrite(std::uint32_t offset, std::string_view bytes);

  /// Flushes to the disk and renames. Afterwards nothing more can be written.
  /// @throws std::runtime_error
  void finish();

 private:
  std::string path_;    ///< as it was asked for
  std::string target_;  ///< see behind_links()
  std::string part_;
  int descriptor_ = -1;
};

}  // namespace fixproof::support
