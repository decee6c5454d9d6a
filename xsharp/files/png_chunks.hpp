/// @file
/// Reads and writes the chunks of a PNG.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace xsharp {

struct PngChunk {
  std::string_view type;  ///< four letters
  std::string_view data;
  std::string_view bytes;  ///< the whole chunk, with length and checksum
};

inline constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// The chunks, as views into `png`. Does not verify checksums.
/// @throws std::invalid_argument unless it is a signature and whole chunks up to IEND
std::vector<PngChunk> png_chunks(std::string_view png);

/// A chunk: length, type, data and checksum. The type has four letters, the data less than 2^31
/// bytes.
std::string png_chunk(std::string_view type, std::string_view data);

/// The four bytes of a number, big-endian.
std::string png_number(std::uint32_t number);

}  // namespace xsharp
