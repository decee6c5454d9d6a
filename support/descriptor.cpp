#include "support/descriptor.hpp"

#include <unistd.h>

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

}  // namespace fixproof::support
