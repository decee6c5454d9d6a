#include "measure/player/picture_digest.hpp"

#include <fmt/format.h>

#include <utility>

#include "support/sha256.hpp"

namespace fixproof::player {

std::string picture_digest(std::span<const std::uint8_t> pixels) {
  const support::Sha256 digest = support::sha256(std::as_bytes(pixels));
  return fmt::format("{:02x}", fmt::join(std::span(digest).first(8), ""));
}

std::string DigestLines::line_of(std::span<const std::uint8_t> pixels) {
  std::string digest = picture_digest(pixels);
  if (digest == last_) return "";
  last_ = std::move(digest);
  return last_ + '\n';
}

}  // namespace fixproof::player
