#include "support/bounded_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace fixproof::support {

namespace {

/// Does not wait for the writer of a pipe.
constexpr int read_flags = O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;

/// Of opening a file while others are renamed. Each takes microseconds.
constexpr int max_attempts = 1000;

[[noreturn]] void refuse_open(int error) {
  if (error == ENOENT) throw std::runtime_error("there is no such file");
  if (error == EXDEV) throw std::runtime_error("leads out of the folder");
  throw std::runtime_error("cannot be opened: " + std::generic_category().message(error));
}

std::string read_regular(const Descriptor& file, std::size_t max_bytes) {
  struct stat status {};
  if (::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) {
    throw std::runtime_error("not a regular file");
  }
  if (status.st_size == 0) throw std::runtime_error("empty");
  if (static_cast<std::uintmax_t>(status.st_size) > max_bytes) {
    throw std::runtime_error(fmt::format("longer than {} MiB", max_bytes >> 20U));
  }
  // No more than there is now: more may come without end.
  std::string text(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t got = ::read(file.number(), text.data() + done, text.size() - done);
    if (got == 0) break;
    if (got > 0) {
      done += static_cast<std::size_t>(got);
    } else if (errno != EINTR) {
      throw std::runtime_error("cannot be read: " + std::generic_category().message(errno));
    }
  }
  text.resize(done);
  return text;
}

}  // namespace

Descriptor open_beneath(const std::string& folder, const std::string& file) {
  // NOLINTBEGIN(cppcoreguidelines-pro-type-vararg): open() and syscall() are variadic
  const Descriptor base(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!base.is_open()) refuse_open(errno);
  open_how how{};
  how.flags = read_flags;
  how.resolve = RESOLVE_BENEATH | RESOLVE_NO_MAGICLINKS;
  // The kernel gives up with EAGAIN if any file is renamed while it follows `..`.
  for (int attempts = 0; attempts < max_attempts; ++attempts) {
    const auto number =
        static_cast<int>(::syscall(SYS_openat2, base.number(), file.c_str(), &how, sizeof how));
    if (number >= 0) return Descriptor(number);
    if (errno != EAGAIN && errno != EINTR) break;
  }
  // NOLINTEND(cppcoreguidelines-pro-type-vararg)
  // Sandboxes answer EPERM to calls that they do not know.
  if (errno == ENOSYS || errno == EPERM) return open_beneath_by_names(folder, file);
  refuse_open(errno);
}

Descriptor open_beneath_by_names(const std::string& folder, const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path base = fs::canonical(folder, error);
  if (error) refuse_open(error.value());
  const fs::path real = fs::canonical(base / file, error);
  if (error) refuse_open(error.value());
  if (fs::path(file).is_absolute() ||
      std::mismatch(base.begin(), base.end(), real.begin(), real.end()).first != base.end()) {
    refuse_open(EXDEV);
  }
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): open() is variadic
  Descriptor opened(::open(real.c_str(), read_flags | O_NOFOLLOW));
  if (!opened.is_open()) refuse_open(errno);
  return opened;
}

std::string read_bounded(const std::string& file, std::size_t max_bytes) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): open() is variadic
  const Descriptor opened(::open(file.c_str(), read_flags));
  if (!opened.is_open()) refuse_open(errno);
  return read_regular(opened, max_bytes);
}

std::string read_beneath(const std::string& folder, const std::string& file,
                         std::size_t max_bytes) {
  return read_regular(open_beneath(folder, file), max_bytes);
}

}  // namespace fixproof::support
