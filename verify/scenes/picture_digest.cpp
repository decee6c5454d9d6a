#include "verify/scenes/picture_digest.hpp"

#include <fmt/format.h>

#include <utility>

#include "verify/sha256.hpp"

namespace fixproof {

std::string picture_digest(std::span<const std::uint8_t> pixels) {
  const auto words = sha256(pixels);
  return fmt::format("{:08x}{:08x}", words[0], words[1]);
}

std::string DigestLines::line_of(std::span<const std::uint8_t> pixels) {
  std::string digest = picture_digest(pixels);
  if (digest == last_) return "";
  last_ = std::move(digest);
  return last_ + '\n';
}

}  // namespace fixproof
