/// @file
/// SHA-256 (FIPS 180-4).
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace fixproof {

/// The digest's eight words, the first one first.
std::array<std::uint32_t, 8> sha256(std::span<const std::uint8_t> bytes);

}  // namespace fixproof
