/// @file
/// The file of a log, which one log of one process writes.
#pragma once

#include <cstddef>
#include <cstdio>

#if (defined(__unix__) || defined(__APPLE__)) && __has_include(<sys/file.h>)
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#define FIXPROOF_RECORD_LOCKS
#elif defined(_WIN32)
#include <share.h>
#endif

namespace fixproof::record {

/// A file that is written from its beginning, without a buffer: every write reaches the system at
/// once, so that nothing is lost if the program is killed.
///
/// A second writer is refused: another log, another process, and the child of a fork, which shares
/// the place in the file with its parent. A system without these means refuses none.
// NOLINTBEGIN(cppcoreguidelines-owning-memory): this class owns the file
class sole_file {
 public:
  /// Opens the file and empties it.
  explicit sole_file(const char* path) noexcept : file_(opened(path)) {
    if (file_ != nullptr) std::setvbuf(file_, nullptr, _IONBF, 0);
  }
  ~sole_file() { close(); }
  sole_file(const sole_file&) = delete;
  sole_file(sole_file&&) = delete;
  sole_file& operator=(const sole_file&) = delete;
  sole_file& operator=(sole_file&&) = delete;

  /// Returns why nothing more is written, or an empty text.
  [[nodiscard]] const char* problem() const noexcept {
    return is_owner() ? problem_ : "a child process does not write the log of its parent";
  }

  /// Writes bytes. After an error it writes nothing more.
  void write(const unsigned char* bytes, std::size_t count) noexcept {
    if (file_ == nullptr || !is_owner() || std::fwrite(bytes, 1, count, file_) == count) return;
    problem_ = "the file cannot be written";
    close();
  }

 private:
#if defined(FIXPROOF_RECORD_LOCKS)
  std::FILE* opened(const char* path) noexcept {
    // A program that this one starts must not keep the lock.
    const int number = ::open(path, O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (number < 0) return nullptr;
    struct stat about {};
    // Many may write a device, such as /dev/null, which has nothing to empty.
    if (::fstat(number, &about) == 0 && S_ISREG(about.st_mode)) {
      if (::flock(number, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        problem_ = "another process or log has this file open";
      } else if (::ftruncate(number, 0) == 0) {  // not before the lock: the file may be in use
        problem_ = "";
      }
    } else {
      problem_ = "";
    }
    std::FILE* const file = *problem_ == '\0' ? ::fdopen(number, "wb") : nullptr;
    if (file == nullptr) ::close(number);
    return file;
  }

  [[nodiscard]] bool is_owner() const noexcept { return ::getpid() == owner_; }

  void close() noexcept {
    if (file_ == nullptr) return;
    // A child that still runs has the file open, too, and would keep the lock.
    if (is_owner()) ::flock(::fileno(file_), LOCK_UN);
    std::fclose(file_);
    file_ = nullptr;
  }

  pid_t owner_ = ::getpid();
#else
  std::FILE* opened(const char* path) noexcept {
#if defined(_WIN32)
    std::FILE* const file = ::_fsopen(path, "wb", _SH_DENYWR);
#else
    std::FILE* const file = std::fopen(path, "wb");
#endif
    if (file != nullptr) problem_ = "";
    return file;
  }

  [[nodiscard]] static bool is_owner() noexcept { return true; }

  void close() noexcept {
    if (file_ == nullptr) return;
    std::fclose(file_);
    file_ = nullptr;
  }
#endif

#if defined(_WIN32)
  const char* problem_ = "the file cannot be opened; another process or log may have it open";
#else
  const char* problem_ = "the file cannot be opened";
#endif
  std::FILE* file_;
};
// NOLINTEND(cppcoreguidelines-owning-memory)

}  // namespace fixproof::record

#undef FIXPROOF_RECORD_LOCKS
