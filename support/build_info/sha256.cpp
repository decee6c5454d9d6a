#include "support/build_info/sha256.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/evp.h>

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>

namespace fixproof::support {

std::string sha256(std::string_view bytes) {
  std::array<std::uint8_t, EVP_MAX_MD_SIZE> sum{};
  unsigned size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), sum.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("libcrypto cannot compute a SHA-256");
  }
  return fmt::format("{:02x}", fmt::join(std::span(sum).first(size), ""));
}

}  // namespace fixproof::support
