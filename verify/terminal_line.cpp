#include "verify/terminal_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace fixproof {

TerminalLine::TerminalLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}

TerminalLine::~TerminalLine() {
  if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void TerminalLine::show(std::string_view text) {
  if (!terminal_) return;
  fmt::print(stderr, "\r{}\x1b[K", text);
  drawn_ = true;
}

}  // namespace fixproof
