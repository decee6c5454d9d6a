#include "support/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <boost/noncopyable.hpp>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "support/part_file.hpp"

namespace fixproof::support {

namespace {

constexpr std::size_t max_read = std::size_t{256} << 20U;

[[noreturn]] void fail(std::string_view what, const std::string& path, int error) {
  throw std::runtime_error(
      fmt::format("cannot {} {}: {}", what, path, std::generic_category().message(error)));
}

class File : private boost::noncopyable {
 public:
  File(const std::string& path, int flags)
      // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): open() is variadic
      : path_(path), descriptor_(::open(path.c_str(), flags | O_CLOEXEC)) {
    if (descriptor_ < 0) fail(flags == O_RDONLY ? "read" : "write", path_, errno);
  }
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  void write(std::string_view contents) {
    while (!contents.empty()) {
      const ssize_t written = ::write(descriptor_, contents.data(), contents.size());
      if (written >= 0) {
        contents.remove_prefix(static_cast<std::size_t>(written));
      } else if (errno != EINTR) {
        fail("write", path_, errno);
      }
    }
  }

  /// Flushes to disk and closes. Only this reveals late write errors.
  void finish() {
    const bool flushed = ::fsync(descriptor_) == 0 || errno == EINVAL || errno == EROFS;
    const int error = errno;
    const bool closed = ::close(std::exchange(descriptor_, -1)) == 0;
    if (!flushed) fail("write", path_, error);
    if (!closed) fail("write", path_, errno);
  }

  std::string read() {
    std::string contents;
    std::array<char, 65536> buffer{};
    for (;;) {
      const ssize_t got = ::read(descriptor_, buffer.data(), buffer.size());
      if (got == 0) return contents;
      if (got > 0) {
        contents.append(buffer.data(), static_cast<std::size_t>(got));
        if (contents.size() > max_read) fail("read", path_, EFBIG);
      } else if (errno != EINTR) {
        fail("read", path_, errno);
      }
    }
  }

 private:
  const std::string& path_;
  int descriptor_;
};

/// Returns whether the path exists and renaming over it would destroy it, such as a device or a
/// pipe.
bool is_special(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

}  // namespace

void replace_file(const std::string& path, std::string_view contents) {
  if (is_special(path)) {
    File file(path, O_WRONLY);
    file.write(contents);
    file.finish();
    return;
  }
  PartFile file(path);
  file.append(contents);
  file.finish();
}

void check_replaceable(const std::string& path) {
  if (is_special(path)) {
    if (std::filesystem::is_directory(path)) fail("write", path, EISDIR);
    // Does not open it: closing a pipe would signal end of file to its reader.
    if (::access(path.c_str(), W_OK) != 0) fail("write", path, errno);
    return;
  }
  const PartFile unfinished(path);
}

bool same_file(const std::string& a, const std::string& b) {
  // Hard links have different paths.
  std::error_code error;
  return behind_links(a) == behind_links(b) || std::filesystem::equivalent(a, b, error);
}

std::string read_file(const std::string& path) { return File(path, O_RDONLY).read(); }

}  // namespace fixproof::support
