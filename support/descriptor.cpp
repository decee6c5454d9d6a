#include "support/descriptor.hpp"

#include <fcntl.h>
#include <unistd.h>
#if defined(__linux__) && __has_include(<linux/close_range.h>)
#include <linux/close_range.h>
#include <sys/syscall.h>
#endif

#include <algorithm>
#include <cerrno>

namespace fixproof::support {

namespace {

/// Calls `write` with the rest of `bytes` until nothing is left. @return 0, or the error number
template <class Write>
int write_all(std::string_view bytes, Write write) {
  while (!bytes.empty()) {
    const ssize_t written = write(bytes);
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

int Descriptor::append(std::string_view bytes) const {
  return write_all(
      bytes, [this](std::string_view rest) { return ::write(number_, rest.data(), rest.size()); });
}

int Descriptor::overwrite(std::uint32_t offset, std::string_view bytes) const {
  off_t at{offset};
  return write_all(bytes, [&](std::string_view rest) {
    const ssize_t written = ::pwrite(number_, rest.data(), rest.size(), at);
    if (written > 0) at += written;
    return written;
  });
}

int Descriptor::flush() const {
  return ::fsync(number_) == 0 || errno == EINVAL || errno == EROFS ? 0 : errno;
}

void close_descriptors(unsigned first, unsigned last, Closing when) {
#ifdef CLOSE_RANGE_CLOEXEC
  const unsigned flags = when == Closing::at_exec ? CLOSE_RANGE_CLOEXEC : 0;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): old C libraries have no function for it
  if (syscall(SYS_close_range, first, last, flags) == 0) return;
#endif
  constexpr unsigned most = 4095;
  for (unsigned i = first; i <= std::min(last, most); ++i) {
    const int number = static_cast<int>(i);
    if (when == Closing::now) {
      ::close(number);
    } else {
      ::fcntl(number, F_SETFD, FD_CLOEXEC);
    }
  }
}

}  // namespace fixproof::support
