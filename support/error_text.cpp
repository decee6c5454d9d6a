#include "support/error_text.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace fixproof::support {

void write_error(std::string_view text) noexcept {
  // fmt::print() would throw if the write fails.
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

void occupy_closed_descriptors() noexcept {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // NOLINTBEGIN(cppcoreguidelines-pro-type-vararg): POSIX's functions are variadic
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    // open() returns the lowest free descriptor, which is this one.
    static_cast<void>(::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY));
    // NOLINTEND(cppcoreguidelines-pro-type-vararg)
  }
}

}  // namespace fixproof::support
