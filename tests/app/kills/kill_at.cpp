/// @file
/// For LD_PRELOAD: kills the process before one call that works with files.
///
/// KILL_AT="renameat 2" kills it before its second renameat(). KILL_COUNTS=FILE has it write to
/// that file, when it ends, how often it has called each function.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

enum Function { opening, closing, flushing, renaming, unlinking, functions };
constexpr std::array<const char*, functions> names{"openat", "close", "fsync", "renameat",
                                                   "unlinkat"};

std::array<std::atomic<int>, functions> counts{};

void count(Function function) {
  const int number = ++counts.at(function);
  const char* const wanted = std::getenv("KILL_AT");
  if (wanted == nullptr) return;
  const std::size_t length = std::strlen(names.at(function));
  if (std::strncmp(wanted, names.at(function), length) == 0 && wanted[length] == ' ' &&
      std::atoi(wanted + length) == number) {
    ::kill(::getpid(), SIGKILL);
    ::pause();  // until the signal arrives
  }
}

template <class Next>
Next next(const char* name) {
  return reinterpret_cast<Next>(::dlsym(RTLD_NEXT, name));
}

struct AtEnd {
  ~AtEnd() {
    const char* const file = std::getenv("KILL_COUNTS");
    if (file == nullptr) return;
    std::FILE* const to = std::fopen(file, "w");
    if (to == nullptr) std::abort();
    for (std::size_t i = 0; i < functions; ++i) {
      std::fprintf(to, "%s %d\n", names.at(i), counts.at(i).load());
    }
    std::fclose(to);
  }
};
const AtEnd at_end;

}  // namespace

extern "C" {

int openat(int folder, const char* path, int flags, ...) {
  std::va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & (O_CREAT | __O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  count(opening);
  return static_cast<int>(::syscall(SYS_openat, folder, path, flags, mode));
}

int close(int descriptor) {
  count(closing);
  return next<int (*)(int)>("close")(descriptor);
}

int fsync(int descriptor) {
  count(flushing);
  return next<int (*)(int)>("fsync")(descriptor);
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
  count(renaming);
  return next<int (*)(int, const char*, int, const char*)>("renameat")(from_folder, from, to_folder,
                                                                       to);
}

int unlinkat(int folder, const char* path, int flags) noexcept {
  count(unlinking);
  return next<int (*)(int, const char*, int)>("unlinkat")(folder, path, flags);
}

}  // extern "C"
