#include "support/sha256.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace fixproof::support {

namespace {

std::string hex_of(const Sha256& digest) { return fmt::format("{:02x}", fmt::join(digest, "")); }

[[noreturn]] void refuse() { throw std::runtime_error("libcrypto cannot compute a SHA-256"); }

}  // namespace

Sha256 sha256(std::span<const std::byte> bytes) {
  Sha256 digest{};
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    refuse();
  }
  return digest;
}

std::string sha256_hex(std::string_view text) {
  return hex_of(sha256(std::as_bytes(std::span(text))));
}

std::string sha256_hex_of_file(const std::string& path) {
  const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(),
                                                                   EVP_MD_CTX_free);
  if (!context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1) refuse();
  std::ifstream file(path, std::ios::binary);
  std::array<char, 65536> piece{};
  do {
    file.read(piece.data(), piece.size());
    const auto got = static_cast<std::size_t>(file.gcount());
    if (EVP_DigestUpdate(context.get(), piece.data(), got) != 1) refuse();
  } while (file);
  if (!file.eof() || file.bad()) throw std::runtime_error("cannot read " + path);
  Sha256 digest{};
  if (EVP_DigestFinal_ex(context.get(), digest.data(), nullptr) != 1) refuse();
  return hex_of(digest);
}

}  // namespace fixproof::support
