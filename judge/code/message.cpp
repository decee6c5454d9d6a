#include "judge/code/message.hpp"

#include <cstdint>
#include <cstring>
#include <utility>

namespace fixproof::judge {

namespace {

using Length = std::uint32_t;

}  // namespace

std::string length_of(std::string_view message) {
  const auto length = static_cast<Length>(message.size());
  std::string bytes(sizeof length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  return bytes;
}

void IncomingMessage::add(std::string_view piece) {
  // No more than this process must hold: one byte too many shows that the length is false.
  const std::size_t most = sizeof(Length) + longest_ + 1;
  bytes_ += piece.substr(0, most - bytes_.size());
}

IncomingMessage::State IncomingMessage::state() const {
  Length length = 0;
  if (bytes_.size() < sizeof length) return State::incomplete;
  std::memcpy(&length, bytes_.data(), sizeof length);
  const std::size_t arrived = bytes_.size() - sizeof length;
  if (length > longest_ || arrived > length) return State::false_length;
  return arrived == length ? State::whole : State::incomplete;
}

std::string IncomingMessage::take() {
  bytes_.erase(0, sizeof(Length));
  return std::exchange(bytes_, {});
}

}  // namespace fixproof::judge
