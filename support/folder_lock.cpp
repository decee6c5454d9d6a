#include "support/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "support/usage_error.hpp"

namespace fixproof::support {

FolderLock::FolderLock(const std::string& option, const std::string& folder)
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): open() is variadic
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0) {
    throw UsageError(fmt::format("{} {}: cannot open this folder: {}", option, folder,
                                 std::generic_category().message(errno)));
  }
  // On a file system without locks the folder stays unlocked.
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(descriptor_);
    throw UsageError(
        fmt::format("{} {}: another run writes to this folder; wait for it, or name another folder",
                    option, folder));
  }
}

FolderLock::~FolderLock() { close(descriptor_); }

}  // namespace fixproof::support
