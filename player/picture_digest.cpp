#include "player/picture_digest.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace fixproof::player {

std::string picture_digest(std::span<const std::uint8_t> pixels) {
  std::array<std::uint8_t, EVP_MAX_MD_SIZE> sum{};
  if (EVP_Digest(pixels.data(), pixels.size(), sum.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("libcrypto cannot compute a SHA-256");
  }
  return fmt::format("{:02x}", fmt::join(std::span(sum).first(8), ""));
}

std::string DigestLines::line_of(std::span<const std::uint8_t> pixels) {
  std::string digest = picture_digest(pixels);
  if (digest == last_) return "";
  last_ = std::move(digest);
  return last_ + '\n';
}

}  // namespace fixproof::player
