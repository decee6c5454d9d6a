#include "xsharp/files/part_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace xsharp {

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw std::runtime_error("cannot write " + path + ": " + reason);
}

[[noreturn]] void fail(const std::string& path, int error) {
  fail(path, std::generic_category().message(error));
}

}  // namespace

std::string behind_links(const std::string& path) {
  std::error_code error;
  const auto target =
      std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  return error ? path : target.string();
}

PartFile::PartFile(const std::string& path) : path_(path), target_(behind_links(path)) {
  std::error_code error;
  const auto status = std::filesystem::status(target_, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    fail(path_, "not a regular file");
  }
  // Always a new file: what is there already may be another run's, or lead elsewhere.
  constexpr int most_tries = 100;
  for (int number = 1; descriptor_ < 0; ++number) {
    part_ = target_;
    if (number > 1) part_.append(".").append(std::to_string(number));
    part_.append(".part");
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): POSIX has no other
    descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && (errno != EEXIST || number == most_tries)) fail(path_, errno);
  }
}

PartFile::~PartFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(part_.c_str());
}

void PartFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      fail(path_, errno);
    }
  }
}

void PartFile::overwrite(std::uint32_t offset, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), off_t{offset});
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
      offset += static_cast<std::uint32_t>(written);
    } else if (errno != EINTR) {
      fail(path_, errno);
    }
  }
}

void PartFile::finish() {
  const auto leave = [this](int error) {
    ::unlink(part_.c_str());
    fail(path_, error);
  };
  // Some file systems cannot flush: that is no failure to write.
  const bool flushed = ::fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS;
  const int error = errno;
  const bool closed = ::close(std::exchange(descriptor_, -1)) == 0;
  if (!flushed) leave(error);
  if (!closed) leave(errno);
  if (std::rename(part_.c_str(), target_.c_str()) != 0) leave(errno);
}

}  // namespace xsharp
