/// @file
/// The line on which long work shows how far it is.
#pragma once

#include <boost/noncopyable.hpp>
#include <string_view>

namespace fixproof::support {

/// One line on stderr, drawn over and over and erased at the end. If stderr is no terminal nothing
/// is written.
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
