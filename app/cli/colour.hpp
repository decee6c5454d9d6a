/// @file
/// Verdicts in colour on a terminal.
#pragma once

#include <boost/noncopyable.hpp>
#include <memory>
#include <streambuf>
#include <string>
#include <string_view>

namespace fixproof::cli {

/// Tells whether standard output is a terminal that takes colours and NO_COLOR is not set, or
/// CLICOLOR_FORCE is set.
bool wants_colour();

/// Returns a line with its verdicts in colour: green for right, red for wrong, yellow for
/// undecided.
std::string coloured(std::string_view line);

/// Colours the lines that std::cout gets, while this object lives.
class ColouredOutput : private boost::noncopyable {
 public:
  ColouredOutput();
  ~ColouredOutput();

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
};

}  // namespace fixproof::cli
