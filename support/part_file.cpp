#include "support/part_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace fixproof::support {

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw std::runtime_error("cannot write " + path + ": " + reason);
}

[[noreturn]] void fail(const std::string& path, int error) {
  fail(path, std::generic_category().message(error));
}

}  // namespace

std::string behind_links(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path target = fs::absolute(path, error);
  // The last link may lead to a file that does not exist yet. Follows as many links as the system
  // does.
  for (int links = 0; links < 40 && fs::is_symlink(target, error); ++links) {
    target = target.parent_path() / fs::read_symlink(target, error);
  }
  target = fs::weakly_canonical(target, error);
  if (error) return path;
  return (target.has_filename() ? target : target.parent_path()).string();
}

PartFile::PartFile(const std::string& path) : path_(path), target_(behind_links(path)) {
  std::error_code error;
  const auto status = std::filesystem::status(target_, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    fail(path_, "not a regular file");
  }
  // Always creates a new file: an existing one may belong to another run or be a link.
  constexpr int max_tries = 100;
  for (int number = 1;; ++number) {
    part_ = target_;
    if (number > 1) part_.append(".").append(std::to_string(number));
    part_.append(".part");
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): open() is variadic
    descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) break;
    if (errno != EEXIST) fail(path_, errno);
    if (number == max_tries)
      fail(path_, "remove the files that unfinished runs have left, up to " + part_);
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
  // Another process may have replaced the file of this name.
  struct stat ours {};
  struct stat there {};
  const bool is_in_place = ::fstat(descriptor_, &ours) == 0 &&
                           ::lstat(part_.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
                           ours.st_dev == there.st_dev;
  // Some file systems cannot flush; that is not a write error.
  const bool flushed = ::fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS;
  const int error = errno;
  const bool closed = ::close(std::exchange(descriptor_, -1)) == 0;
  if (!is_in_place) fail(path_, "another file has taken the place of " + part_);
  if (!flushed) leave(error);
  if (!closed) leave(errno);
  if (std::rename(part_.c_str(), target_.c_str()) != 0) leave(errno);
}

}  // namespace fixproof::support
