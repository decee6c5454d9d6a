#include "xsharp/files/png_chunks.hpp"

#include <zlib.h>

#include <stdexcept>

namespace xsharp {

namespace {

/// The big-endian number in the first four bytes.
std::uint32_t number_at(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char byte : bytes.substr(0, 4)) {
    number = number << 8U | static_cast<unsigned char>(byte);
  }
  return number;
}

}  // namespace

std::vector<PngChunk> png_chunks(std::string_view png) {
  if (!png.starts_with(png_signature)) throw std::invalid_argument("not a PNG");
  std::vector<PngChunk> chunks;
  std::string_view rest = png.substr(png_signature.size());
  constexpr std::size_t around = 12;  // length, type and checksum
  while (chunks.empty() || chunks.back().type != "IEND") {
    if (rest.size() < around || rest.size() - around < number_at(rest)) {
      throw std::invalid_argument("the PNG is cut short");
    }
    const std::size_t length = number_at(rest);
    chunks.push_back({rest.substr(4, 4), rest.substr(8, length), rest.substr(0, length + around)});
    rest.remove_prefix(length + around);
  }
  return chunks;
}

std::string png_chunk(std::string_view type, std::string_view data) {
  std::string checked(type);
  checked += data;
  std::vector<unsigned char> bytes(checked.begin(), checked.end());
  const auto checksum = crc32_z(crc32_z(0, nullptr, 0), bytes.data(), bytes.size());
  return png_number(static_cast<std::uint32_t>(data.size())) + checked +
         png_number(static_cast<std::uint32_t>(checksum));
}

std::string png_number(std::uint32_t number) {
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes += static_cast<char>(static_cast<unsigned char>(number >> shift & 255U));
  }
  return bytes;
}

}  // namespace xsharp
