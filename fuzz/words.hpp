/// @file
/// Reads and writes words as inputs: four bytes each, big-endian, so that `xxd -c 8` shows them as
/// `fixproof eval` reads them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fixproof::fuzz {

inline constexpr std::size_t bytes_of_word = 4;

/// Fills `words`. Missing bytes are 0; excess bytes are ignored.
inline void read_words(std::span<const std::uint8_t> bytes, std::span<std::uint32_t> words) {
  for (std::size_t i = 0; i < words.size() * bytes_of_word; ++i) {
    std::uint32_t& word = words[i / bytes_of_word];
    word = word << 8U | (i < bytes.size() ? bytes[i] : 0U);
  }
}

/// Writes as many words as fit in `bytes`.
inline void write_words(std::span<const std::uint32_t> words, std::span<std::uint8_t> bytes) {
  for (std::size_t i = 0; i < words.size() * bytes_of_word && i < bytes.size(); ++i) {
    bytes[i] =
        static_cast<std::uint8_t>(words[i / bytes_of_word] >> (24 - 8 * (i % bytes_of_word)));
  }
}

}  // namespace fixproof::fuzz
