/// @file
/// The memories of machines of words.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "x86model/words.hpp"

namespace x86model {

/// Memory of machine words with byte addresses. Only aligned words inside it are accessible.
template <int WordBits, std::size_t Words>
class WordMemory {
 public:
  static constexpr std::uint32_t bytes_per_word = WordBits / 8;

  /// @return false if there is no word at `address`
  X86MODEL_INLINE bool read(std::uint32_t address, std::uint32_t& value) const {
    if (!contains(address)) return false;
    value = words_[address / bytes_per_word];
    return true;
  }
  X86MODEL_INLINE bool write(std::uint32_t address, std::uint32_t value) {
    if (!contains(address)) return false;
    words_[address / bytes_per_word] = static_cast<std::uint16_t>(value & mask(WordBits));
    return true;
  }

 private:
  X86MODEL_INLINE static bool contains(std::uint32_t address) {
    return address % bytes_per_word == 0 && address / bytes_per_word < Words;
  }

  std::array<std::uint16_t, Words> words_{};
};

/// Byte memory owned by the caller, in the three segments that the loops use: data (DS), extra (ES)
/// and stack (SS), which may alias. A word is two bytes, little-endian, at any address, entirely
/// inside its segment.
class ByteMemory {
 public:
  using Segment = std::span<std::uint8_t>;

  constexpr ByteMemory(Segment data, Segment extra, Segment stack)
      : data_(data), extra_(extra), stack_(stack) {}

  /// @return false if `address` is outside the segment
  X86MODEL_INLINE bool read(std::uint32_t address, std::uint32_t& value) const {
    return read_word(data_, address, value);
  }
  X86MODEL_INLINE bool write(std::uint32_t address, std::uint32_t value) {
    return write_word(data_, address, value);
  }
  X86MODEL_INLINE bool read_byte(std::uint32_t address, std::uint32_t& value) const {
    if (address >= data_.size()) return false;
    value = data_[address];
    return true;
  }
  X86MODEL_INLINE bool write_byte(std::uint32_t address, std::uint32_t value) {
    return write_byte_of(data_, address, value);
  }
  X86MODEL_INLINE bool write_extra_byte(std::uint32_t address, std::uint32_t value) {
    return write_byte_of(extra_, address, value);
  }
  X86MODEL_INLINE bool write_extra_word(std::uint32_t address, std::uint32_t value) {
    return write_word(extra_, address, value);
  }
  X86MODEL_INLINE bool read_stack(std::uint32_t address, std::uint32_t& value) const {
    return read_word(stack_, address, value);
  }
  X86MODEL_INLINE bool write_stack(std::uint32_t address, std::uint32_t value) {
    return write_word(stack_, address, value);
  }

 private:
  X86MODEL_INLINE static bool holds_word(Segment s, std::uint32_t address) {
    return address < s.size() && s.size() - address > 1;
  }
  X86MODEL_INLINE static bool read_word(Segment s, std::uint32_t address, std::uint32_t& value) {
    if (!holds_word(s, address)) return false;
    value = s[address] | static_cast<std::uint32_t>(s[address + 1]) << 8U;
    return true;
  }
  X86MODEL_INLINE static bool write_word(Segment s, std::uint32_t address, std::uint32_t value) {
    if (!holds_word(s, address)) return false;
    s[address] = static_cast<std::uint8_t>(value);
    s[address + 1] = static_cast<std::uint8_t>(value >> 8U);
    return true;
  }
  X86MODEL_INLINE static bool write_byte_of(Segment s, std::uint32_t address, std::uint32_t value) {
    if (address >= s.size()) return false;
    s[address] = static_cast<std::uint8_t>(value);
    return true;
  }

  Segment data_;
  Segment extra_;
  Segment stack_;
};

}  // namespace x86model
