#include "player/picture_digest.hpp"

#include <string_view>
#include <utility>

#include "support/build_info/sha256.hpp"

namespace fixproof::player {

std::string picture_digest(std::span<const std::uint8_t> pixels) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes as characters
  const std::string_view bytes(reinterpret_cast<const char*>(pixels.data()), pixels.size());
  return support::sha256(bytes).substr(0, 16);
}

std::string DigestLines::line_of(std::span<const std::uint8_t> pixels) {
  std::string digest = picture_digest(pixels);
  if (digest == last_) return "";
  last_ = std::move(digest);
  return last_ + '\n';
}

}  // namespace fixproof::player
