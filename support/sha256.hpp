/// @file
/// SHA-256 digests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace fixproof::support {

using Sha256 = std::array<std::uint8_t, 32>;

/// @throws std::runtime_error if libcrypto has no SHA-256
Sha256 sha256(std::span<const std::byte> bytes);

/// Returns the digest of `text` as 64 lower-case hex digits. @throws as sha256()
std::string sha256_hex(std::string_view text);

/// The same of a file of any size, which is read in pieces.
/// @throws std::runtime_error also if it cannot be read
std::string sha256_hex_of_file(const std::string& path);

}  // namespace fixproof::support
