/// @file
/// The progress line on a terminal.
#pragma once

#include <boost/noncopyable.hpp>
#include <string_view>

namespace fixproof::support {

/// One line on stderr, redrawn in place and erased at the end. Silent without a terminal.
class TerminalLine : private boost::noncopyable {
 public:
  TerminalLine();
  ~TerminalLine();

  [[nodiscard]] bool is_seen() const { return terminal_; }
  [[nodiscard]] bool is_drawn() const { return drawn_; }
  void show(std::string_view text);

 private:
  bool terminal_;
  bool drawn_ = false;
};

}  // namespace fixproof::support
