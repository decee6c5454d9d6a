#include "support/part_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>

#include "support/file_lock.hpp"

namespace fixproof::support {

namespace {

/// Without set-user-ID and its like, which any write clears.
constexpr mode_t kept_mode = 0777;

}  // namespace

PartFile::PartFile(const Place& place)
    : place_(place), name_(fmt::format("{}{}", place.name(), part_ending)) {
  const std::optional<struct stat> old = place.check_writable();
  // Closed to others until it has the old mode. Always a new file: an existing one may be a link.
  const mode_t mode = old ? 0600 : 0666;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): openat() is variadic
  file_ = Descriptor(::openat(place.folder(), name_.c_str(),
                              O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
  if (!file_.is_open()) {
    if (errno == EEXIST)
      place.refuse(name_ + " is beside it; remove that, unless another run is writing");
    place.refuse(errno);
  }
  is_ours_ = true;
  try {
    if (old) keep_owner_and_mode(*old);
  } catch (...) {
    ::unlinkat(place_.folder(), name_.c_str(), 0);
    throw;
  }
}

PartFile::~PartFile() {
  if (is_ours_) ::unlinkat(place_.folder(), name_.c_str(), 0);
}

void PartFile::append(std::string_view bytes) { check(file_.append(bytes)); }

void PartFile::overwrite(std::uint32_t offset, std::string_view bytes) {
  check(file_.overwrite(offset, bytes));
}

void PartFile::finish() {
  check(file_.flush());
  if (!place_.holds(name_, file_)) {
    is_ours_ = false;
    place_.refuse("another file has taken the place of " + name_);
  }
  if (::renameat(place_.folder(), name_.c_str(), place_.folder(), place_.name().c_str()) != 0) {
    place_.refuse(errno);
  }
  is_ours_ = false;
  // Only this makes the new name last. A folder that may not be read cannot be flushed.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): openat() is variadic
  const Descriptor folder(::openat(place_.folder(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.is_open()) check(folder.flush());
}

void PartFile::keep_owner_and_mode(const struct stat& old) {
  struct stat now {};
  if (::fstat(file_.number(), &now) != 0) place_.refuse(errno);
  const bool has_owner = now.st_uid == old.st_uid && now.st_gid == old.st_gid;
  // Changing the owner clears bits of the mode, so it comes first.
  if (!has_owner && ::fchown(file_.number(), old.st_uid, old.st_gid) != 0) {
    place_.refuse("its owner and group cannot be kept; remove it, or name another file");
  }
  if ((now.st_mode & kept_mode) != (old.st_mode & kept_mode) &&
      ::fchmod(file_.number(), old.st_mode & kept_mode) != 0) {
    place_.refuse(errno);
  }
}

void PartFile::check(int error) const {
  if (error != 0) place_.refuse(error);
}

}  // namespace fixproof::support
