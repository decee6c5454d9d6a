#include "support/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <system_error>

#include "support/place.hpp"
#include "support/usage_error.hpp"

namespace fixproof::support {

FolderLock::FolderLock(const std::string& option, const std::string& folder) {
  // The name at the end may be a link, which a slash after it would hide.
  const Place place(folder.substr(0, std::max<std::size_t>(1, folder.find_last_not_of('/') + 1)));
  place.check_links();
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): openat() is variadic
  folder_ = Descriptor(::openat(place.folder(), place.name().c_str(),
                                O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!folder_.is_open()) {
    throw UsageError(fmt::format("{} {}: cannot open this folder: {}", option, folder,
                                 std::generic_category().message(errno)));
  }
  // On a file system without locks the folder stays unlocked.
  if (::flock(folder_.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw UsageError(
        fmt::format("{} {}: another run writes to this folder; wait for it, or name another folder",
                    option, folder));
  }
}

}  // namespace fixproof::support
