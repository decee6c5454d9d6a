#include "support/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
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
    : place_(place), name_(fmt::format("{}{}", place.name(), lock_ending)) {
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
  } while (!place.holds(name_, file_));
  ::unlinkat(place.folder(), fmt::format("{}{}", place.name(), part_ending).c_str(), 0);
}

FileLock::~FileLock() {
  // Before the lock ends: the next run may make this file anew.
  if (place_.holds(name_, file_)) ::unlinkat(place_.folder(), name_.c_str(), 0);
}

void remove_leftovers(const std::string& folder) {
  std::set<std::string> names;
  std::error_code error;
  // A range-based for would throw at a folder that cannot be read to its end.
  const std::filesystem::directory_iterator end;
  for (std::filesystem::directory_iterator entry(folder, error); !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    for (const std::string_view ending : {lock_ending, part_ending}) {
      if (name.size() > ending.size() && name.ends_with(ending)) {
        names.insert(name.substr(0, name.size() - ending.size()));
      }
    }
  }
  for (const std::string& name : names) {
    try {
      const Place place(folder + "/" + name);
      // A link leads elsewhere, to what another user may have chosen.
      if (place.folder_path() + place.name() != place.path()) continue;
      const FileLock removes_them(place);
    } catch (const std::runtime_error&) {
      // A live run's, or another user's.
    }
  }
}

}  // namespace fixproof::support
