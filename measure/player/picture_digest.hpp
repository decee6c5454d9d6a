/// @file
/// Digests of pictures, for comparison with recordings of the original programs.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace fixproof::player {

/// The first 16 hex digits of the SHA-256 of a picture's indices, row-major.
std::string picture_digest(std::span<const std::uint8_t> pixels);

/// Digests of consecutive pictures. Equal neighbours give one, as a viewer sees no change.
class DigestLines {
 public:
  /// Returns the digest and a line end; empty if it equals the previous digest.
  std::string line_of(std::span<const std::uint8_t> pixels);

 private:
  std::string last_;
};

}  // namespace fixproof::player
