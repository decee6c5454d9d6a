/// @file
/// The messages between a confined process and its parent: a length in 4 bytes of this machine's
/// order, then as many bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace fixproof::judge {

/// Returns the bytes before a message of less than 4 GiB.
std::string length_of(std::string_view message);

/// A message that arrives piece by piece from a process that may send anything.
class IncomingMessage {
 public:
  enum class State {
    incomplete,
    whole,
    false_length,  ///< it claims to be longer than allowed, or more bytes follow it
  };

  /// @param longest the length that is allowed
  explicit IncomingMessage(std::size_t longest) : longest_(longest) {}

  void add(std::string_view piece);
  [[nodiscard]] State state() const;
  /// Returns the message without its length, if it is whole.
  std::string take();

 private:
  std::size_t longest_;
  std::string bytes_;
};

}  // namespace fixproof::judge
