/// @file
/// Numbers in memory.
#pragma once

#include <cstdint>

namespace fixproof::judge {

/// Writes a number of at most 8 bytes, the lowest byte first unless the memory is big-endian.
inline void store(std::uint8_t* to, std::uint64_t value, int bytes, bool is_big_endian = false) {
  for (int i = 0; i < bytes; ++i) {
    to[is_big_endian ? bytes - 1 - i : i] = static_cast<std::uint8_t>(value >> (8 * i) & 0xFFU);
  }
}

/// Reads a number of at most 8 bytes.
inline std::uint64_t fetch(const std::uint8_t* from, int bytes, bool is_big_endian = false) {
  std::uint64_t value = 0;
  for (int i = 0; i < bytes; ++i) {
    value |= std::uint64_t{from[is_big_endian ? bytes - 1 - i : i]} << (8 * i);
  }
  return value;
}

}  // namespace fixproof::judge
