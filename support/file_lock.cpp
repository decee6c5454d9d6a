#include "support/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace fixproof::support {

namespace {

constexpr std::string_view lock_ending = ".fixproof-lock";

}  // namespace

FileLock::FileLock(const Place& place)
    : place_(place), name_(place.name() + std::string(lock_ending)) {
  const auto refuse = [&](int error) {
    place.refuse(name_ + " beside it: " + std::generic_category().message(error));
  };
  if (place.name().ends_with(part_ending) || place.name().ends_with(lock_ending)) {
    place.refuse("this ending is for unfinished files; name another file");
  }
  // A run that ends removes its lock file, so the one that is locked here may be gone.
  do {
    constexpr mode_t by_all = 0666;
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): openat() is variadic
    file_ = Descriptor(::openat(place.folder(), name_.c_str(),
                                O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC,
                                by_all));
    if (!file_.is_open()) refuse(errno);
    if (::flock(file_.number(), LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK) {
        place.refuse("another run writes this file; wait for it, or name another");
      }
      // A file system without locks. Leaves unfinished files, because a live run may write them.
      return;
    }
  } while (!is_in_place());
  ::unlinkat(place.folder(), (place.name() + std::string(part_ending)).c_str(), 0);
}

FileLock::~FileLock() {
  // Before the lock ends: the next run may make this file anew.
  if (is_in_place()) ::unlinkat(place_.folder(), name_.c_str(), 0);
}

bool FileLock::is_in_place() const {
  struct stat ours {};
  struct stat there {};
  return ::fstat(file_.number(), &ours) == 0 &&
         ::fstatat(place_.folder(), name_.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 &&
         ours.st_ino == there.st_ino && ours.st_dev == there.st_dev;
}

void remove_leftovers(const std::string& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    for (const std::string_view ending : {lock_ending, part_ending}) {
      if (name.size() > ending.size() && name.ends_with(ending)) {
        names.insert(name.substr(0, name.size() - ending.size()));
      }
    }
  }
  for (const std::string& name : names) {
    try {
      const Place place(folder + "/" + name);
      const FileLock removes_them(place);
    } catch (const std::runtime_error&) {
      // A live run's, or another user's.
    }
  }
}

}  // namespace fixproof::support
