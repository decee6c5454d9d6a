#include "support/terminal_line.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "support/error_text.hpp"

namespace fixproof::support {

namespace {

/// Cuts the text to the window's width, because a wrapped line cannot be redrawn.
std::string_view cut_to_window(std::string_view text) {
  winsize window{};
  if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0) return text;
  return text.substr(0, window.ws_col - 1U);
}

}  // namespace

TerminalLine::TerminalLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}

TerminalLine::~TerminalLine() {
  if (drawn_) write_error("\r\x1b[K");
}

void TerminalLine::show(std::string_view text) {
  if (!terminal_) return;
  write_error(fmt::format("\r{}\x1b[K", cut_to_window(text)));
  drawn_ = true;
}

}  // namespace fixproof::support
