/// @file
/// Captures what a run writes to standard output or standard error, by whatever means.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>

#include "fuzz/finding.hpp"

/// Of the sanitizers' runtime, if there is one.
// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" void __sanitizer_set_report_fd(void* descriptor) __attribute__((weak));

namespace fixproof::fuzz {

/// Sends a descriptor to a file in memory until text() is called.
class CapturedOutput {
 public:
  /// @param descriptor STDOUT_FILENO or STDERR_FILENO
  explicit CapturedOutput(int descriptor)
      : descriptor_(descriptor),
        before_(fcntl(descriptor, F_DUPFD_CLOEXEC, 3)),
        file_(memfd_create("output", MFD_CLOEXEC)) {
    if (before_ < 0 || file_ < 0) report_finding("no file in memory");
    report_to(before_);
    std::fflush(nullptr);
    dup2(file_, descriptor_);
  }
  ~CapturedOutput() {
    close(file_);
    close(before_);
  }
  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput(CapturedOutput&&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;
  CapturedOutput& operator=(CapturedOutput&&) = delete;

  /// Restores the descriptor and returns what was written.
  [[nodiscard]] std::string text() const {
    std::fflush(nullptr);
    dup2(before_, descriptor_);
    report_to(descriptor_);
    std::string text;
    std::array<char, 4096> part{};
    for (off_t at = 0;;) {
      const ssize_t count = pread(file_, part.data(), part.size(), at);
      if (count <= 0) return text;
      text.append(part.data(), static_cast<std::size_t>(count));
      at += count;
    }
  }

 private:
  /// Sanitizers write their reports to standard error, which must stay readable.
  void report_to(int descriptor) const {
    if (descriptor_ != STDERR_FILENO || __sanitizer_set_report_fd == nullptr) return;
    // NOLINTNEXTLINE(*-reinterpret-cast,performance-no-int-to-ptr): the interface of sanitizers
    __sanitizer_set_report_fd(reinterpret_cast<void*>(static_cast<std::intptr_t>(descriptor)));
  }

  int descriptor_;
  int before_;
  int file_;
};

}  // namespace fixproof::fuzz
