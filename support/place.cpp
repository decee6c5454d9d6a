#include "support/place.hpp"

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/statfs.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <climits>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace fixproof::support {

namespace {

/// The kernel follows as many.
constexpr int max_links = 40;

/// Tells whether users other than its owner may add files to a folder but not remove those of
/// others, as in /tmp.
bool is_shared(const struct stat& folder, mode_t writers) {
  return (folder.st_mode & S_ISVTX) != 0 && (folder.st_mode & writers) != 0;
}

/// Tells whether a file belongs to neither this process's user nor the folder's.
bool is_foreign(const struct stat& file, const struct stat& folder) {
  return file.st_uid != ::geteuid() && file.st_uid != folder.st_uid;
}

}  // namespace

Place::Place(std::string path) : path_(std::move(path)) {
  if (path_.empty()) refuse(ENOENT);
  go_to(path_);
  for (int links = 0;; ++links) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): openat() is variadic
    const Descriptor file(::openat(folder(), name_.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC));
    if (!file.is_open()) {
      if (errno == ENOENT) return;
      refuse(errno);
    }
    struct stat link {};
    struct stat around {};
    if (::fstat(file.number(), &link) != 0 || ::fstat(folder(), &around) != 0) refuse(errno);
    if (!S_ISLNK(link.st_mode)) return;
    if (is_in_proc()) {
      struct stat own {};
      int number = 0;
      const char* const end = name_.data() + name_.size();
      if (::stat("/proc/self/fd", &own) != 0 || own.st_ino != around.st_ino ||
          std::from_chars(name_.data(), end, number).ptr != end) {
        refuse("a link of /proc; name the file itself");
      }
      open_descriptor_ = number;
      return;
    }
    if (links == max_links) refuse(ELOOP);
    if (is_shared(around, S_IWOTH) && is_foreign(link, around)) is_behind_foreign_link_ = true;
    std::array<char, PATH_MAX> target{};
    const ssize_t length = ::readlinkat(file.number(), "", target.data(), target.size());
    if (length < 0) refuse(errno);
    go_to({target.data(), static_cast<std::size_t>(length)});
  }
}

void Place::go_to(const std::string& path) {
  const auto begin = path.rfind('/') + 1;  // 0 without a slash
  std::string parent = begin == 0 ? "./" : path.substr(0, begin);
  name_ = path.substr(begin);
  if (name_.empty() || name_ == "." || name_ == "..") {
    parent = path + "/";
    name_ = std::string(1, '.');
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): openat() is variadic
  Descriptor next(::openat(folder_.is_open() ? folder() : AT_FDCWD, parent.c_str(),
                           O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!next.is_open()) refuse(errno);
  folder_ = std::move(next);
  folder_path_ = parent.starts_with('/') ? parent : folder_path_ + parent;
}

bool Place::is_in_proc() const {
  struct statfs system {};
  return ::fstatfs(folder(), &system) == 0 && system.f_type == PROC_SUPER_MAGIC;
}

void Place::check_links() const {
  if (is_behind_foreign_link_) {
    refuse("a link of another user in a folder where everyone may write; name the file itself");
  }
}

std::optional<struct stat> Place::check_writable() const {
  check_links();
  if (open_descriptor_) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): fcntl() is variadic
    const int flags = ::fcntl(*open_descriptor_, F_GETFL);
    if (flags < 0) refuse(errno);
    if ((flags & O_ACCMODE) == O_RDONLY || (flags & O_PATH) != 0) refuse(EBADF);
    return {};
  }
  struct stat file {};
  struct stat around {};
  if (::fstatat(folder(), name_.c_str(), &file, AT_SYMLINK_NOFOLLOW) != 0) {
    if (errno == ENOENT) return {};
    refuse(errno);
  }
  if (::fstat(folder(), &around) != 0) refuse(errno);
  if (S_ISDIR(file.st_mode)) refuse(EISDIR);
  if (S_ISLNK(file.st_mode)) refuse(ELOOP);  // the file was replaced by a link just now
  if ((S_ISREG(file.st_mode) || S_ISFIFO(file.st_mode)) && is_shared(around, S_IWOTH | S_IWGRP) &&
      is_foreign(file, around)) {
    refuse("a file of another user in a folder where others may write; name another file");
  }
  // Root's access check passes for any mode.
  if ((file.st_mode & (S_IWUSR | S_IWGRP | S_IWOTH)) == 0) {
    refuse("the file is read-only; make it writable, or name another file");
  }
  if (::faccessat(folder(), name_.c_str(), W_OK, AT_EACCESS) != 0) refuse(errno);
  return file;
}

bool Place::holds(const std::string& name, const Descriptor& file) const {
  struct stat ours {};
  struct stat there {};
  return ::fstat(file.number(), &ours) == 0 &&
         ::fstatat(folder(), name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 &&
         ours.st_ino == there.st_ino && ours.st_dev == there.st_dev;
}

void Place::refuse(const std::string& reason) const {
  throw std::runtime_error("cannot write " + path_ + ": " + reason);
}

void Place::refuse(int error) const { refuse(std::generic_category().message(error)); }

std::optional<Place> find_place(const std::string& path) {
  try {
    return Place(path);
  } catch (const std::runtime_error&) {
    return {};
  }
}

}  // namespace fixproof::support
