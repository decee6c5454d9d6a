/// @file
/// Where writing to a path ends, and whether it is allowed.
#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>

#include "support/descriptor.hpp"

namespace fixproof::support {

/// The file behind the symbolic links of a path, as a name in an open folder. Links and folders
/// that change later do not move it.
class Place {
 public:
  /// @throws std::runtime_error naming the path and the reason, such as a loop of links; an empty
  /// path names no file
  explicit Place(std::string path);

  [[nodiscard]] const std::string& path() const { return path_; }  ///< as the caller gave it
  [[nodiscard]] int folder() const { return folder_.number(); }
  [[nodiscard]] const std::string& folder_path() const { return folder_path_; }
  [[nodiscard]] const std::string& name() const { return name_; }  ///< ".": the folder itself

  /// The open descriptor of this process that the path names, as /dev/stdout does; otherwise none.
  [[nodiscard]] std::optional<int> open_descriptor() const { return open_descriptor_; }

  /// Refuses links of other users in folders where everyone may write, as the kernel does with
  /// fs.protected_symlinks, but only links at the end: the path itself and what such a link leads
  /// to. A link among the folders of a path passes.
  /// @throws std::runtime_error naming the path and the reason
  void check_links() const;

  /// Returns the status of the file, or nothing if none exists or the path names a descriptor.
  /// Calls check_links(). Refuses files of other users in such folders, as the kernel does with
  /// fs.protected_fifos and protected_regular, and files that no one may write.
  /// @throws std::runtime_error naming the path and the reason
  [[nodiscard]] std::optional<struct stat> check_writable() const;

  /// Tells whether `name` in the folder is the open file, rather than another one or a link.
  [[nodiscard]] bool holds(const std::string& name, const Descriptor& file) const;

  /// @throws std::runtime_error "cannot write PATH: REASON"
  [[noreturn]] void refuse(const std::string& reason) const;
  [[noreturn]] void refuse(int error) const;

 private:
  /// Takes the folder and the name from the end of `path`, which is relative to the present folder.
  void go_to(const std::string& path);
  [[nodiscard]] bool is_in_proc() const;

  std::string path_;
  Descriptor folder_;
  std::string folder_path_;
  std::string name_;
  std::optional<int> open_descriptor_;
  bool is_behind_foreign_link_ = false;
};

/// Returns the place, or nothing if it cannot be found.
std::optional<Place> find_place(const std::string& path);

}  // namespace fixproof::support
