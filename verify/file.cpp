#include "verify/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace fixproof {

namespace {

constexpr std::size_t most_read = std::size_t{256} << 20U;

[[noreturn]] void fail(std::string_view what, const std::string& path, int error) {
  throw std::runtime_error(
      fmt::format("cannot {} {}: {}", what, path, std::generic_category().message(error)));
}

/// An open file; messages name `shown`, the file that was asked for.
class File {
 public:
  File(const std::string& path, const std::string& shown, int flags)
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): POSIX has no other
      : shown_(shown), descriptor_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail(verb(flags), shown_, errno);
  }
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File(File&&) = delete;
  File& operator=(const File&) = delete;
  File& operator=(File&&) = delete;

  void write(std::string_view contents) {
    while (!contents.empty()) {
      const ssize_t written = ::write(descriptor_, contents.data(), contents.size());
      if (written >= 0) {
        contents.remove_prefix(static_cast<std::size_t>(written));
      } else if (errno != EINTR) {
        fail("write", shown_, errno);
      }
    }
  }

  /// Flushed to the disk and closed: only now is it known that all is written.
  void finish() {
    const bool flushed = ::fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS;
    const int error = errno;
    const bool closed = ::close(std::exchange(descriptor_, -1)) == 0;
    if (!flushed) fail("write", shown_, error);
    if (!closed) fail("write", shown_, errno);
  }

  std::string read() {
    std::string contents;
    std::array<char, 65536> buffer{};
    for (;;) {
      const ssize_t got = ::read(descriptor_, buffer.data(), buffer.size());
      if (got == 0) return contents;
      if (got > 0) {
        contents.append(buffer.data(), static_cast<std::size_t>(got));
        if (contents.size() > most_read) fail("read", shown_, EFBIG);
      } else if (errno != EINTR) {
        fail("read", shown_, errno);
      }
    }
  }

 private:
  static std::string_view verb(int flags) {
    return (flags & O_ACCMODE) == O_RDONLY ? "read" : "write";
  }

  const std::string& shown_;
  int descriptor_;
};

/// The file behind links; a link itself must survive the renaming.
std::string target_of(const std::string& path) {
  std::error_code error;
  const auto target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target.string();
}

/// Whether the path is there and is something that renaming would destroy.
bool is_special(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

/// One name for each file, so that a run that was killed leaves no more than one behind.
std::string beside(const std::string& path) { return path + ".part"; }

}  // namespace

void replace_file(const std::string& path, std::string_view contents) {
  const std::string target = target_of(path);
  if (is_special(target)) {
    File file(target, path, O_WRONLY);
    file.write(contents);
    file.finish();
    return;
  }
  const std::string part = beside(target);
  try {
    File file(part, path, O_WRONLY | O_CREAT | O_TRUNC);
    file.write(contents);
    file.finish();
    if (std::rename(part.c_str(), target.c_str()) != 0) fail("write", path, errno);
  } catch (...) {
    ::unlink(part.c_str());
    throw;
  }
}

void check_replaceable(const std::string& path) {
  const std::string target = target_of(path);
  if (is_special(target)) {
    if (std::filesystem::is_directory(target)) fail("write", path, EISDIR);
    // Not opened: to close a pipe again would send its reader away.
    if (::access(target.c_str(), W_OK) != 0) fail("write", path, errno);
    return;
  }
  const std::string part = beside(target);
  { const File file(part, path, O_WRONLY | O_CREAT | O_TRUNC); }
  ::unlink(part.c_str());
}

std::string read_file(const std::string& path) { return File(path, path, O_RDONLY).read(); }

}  // namespace fixproof
