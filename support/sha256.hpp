/// @file
/// SHA-256 digests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fixproof::support {

using Sha256 = std::array<std::uint8_t, 32>;

/// @throws std::runtime_error if libcrypto has no SHA-256
Sha256 sha256(std::span<const std::byte> bytes);

}  // namespace fixproof::support
