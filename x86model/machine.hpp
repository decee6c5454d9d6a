/// @file
/// The machine state: registers, flags and memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "x86model/alu.hpp"
#include "x86model/flags.hpp"
#include "x86model/inline.hpp"
#include "x86model/instruction.hpp"

namespace x86model {

/// The general registers. A dword register has 2 * WordBits bits; its low half is the word
/// register.
template <int WordBits>
class Registers {
 public:
  [[nodiscard]] X86MODEL_INLINE std::uint32_t read(Register r, Size size) const {
    if constexpr (WordBits == 16) {
      if (size == Size::byte) return byte_of(r);
    }
    const Halves& whole = values_[static_cast<std::size_t>(r)];
    if (size == Size::word) return whole.low;
    return whole.low | std::uint32_t{whole.high} << WordBits;
  }

  /// Writing a word or byte register preserves the rest of the dword register.
  X86MODEL_INLINE void write(Register r, Size size, std::uint32_t value) {
    if constexpr (WordBits == 16) {
      if (size == Size::byte) return write_byte(r, value);
    }
    Halves& whole = values_[static_cast<std::size_t>(r)];
    whole.low = half(value);
    if (size != Size::word) whole.high = half(value >> WordBits);
  }

  friend constexpr bool operator==(const Registers&, const Registers&) = default;

 private:
  /// A dword register. Most instructions use only its low half; were it one integer, reading the
  /// whole after a write to one half would wait until that write has left the processor.
  struct Halves {
    std::uint16_t low = 0;
    std::uint16_t high = 0;

    friend constexpr bool operator==(const Halves&, const Halves&) = default;
  };
  X86MODEL_INLINE static std::uint16_t half(std::uint32_t value) {
    return static_cast<std::uint16_t>(value & alu::mask(WordBits));
  }
  /// The dword register that contains a byte register, and the position in it.
  struct Place {
    std::size_t whole;
    unsigned shift;
  };
  X86MODEL_INLINE static Place place_of(Register r) {
    const auto number = static_cast<std::size_t>(r);
    return {number % 4, number < 4 ? 0U : 8U};
  }
  [[nodiscard]] X86MODEL_INLINE std::uint32_t byte_of(Register r) const {
    const Place place = place_of(r);
    return std::uint32_t{values_[place.whole].low} >> place.shift & 0xFFU;
  }
  X86MODEL_INLINE void write_byte(Register r, std::uint32_t value) {
    const Place place = place_of(r);
    std::uint16_t& word = values_[place.whole].low;
    word = half((word & ~(0xFFU << place.shift)) | (value & 0xFFU) << place.shift);
  }

  std::array<Halves, register_count> values_{};
};

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
    words_[address / bytes_per_word] = static_cast<std::uint16_t>(value & alu::mask(WordBits));
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

/// A machine with words of `WordBits` bits and the given memory.
template <int WordBits, class MemoryType>
struct Machine {
  static constexpr int word_bits = WordBits;

  Registers<WordBits> registers;
  Flags flags = all_undefined;
  MemoryType memory;
};

/// A byte count or displacement for 16-bit words, scaled to this width.
template <int WordBits>
X86MODEL_INLINE std::int32_t scaled_bytes(std::int32_t bytes) {
  return bytes * WordBits / 16;
}

/// The address of the cosine table in the code segment, in bytes for 16-bit words.
inline constexpr std::int32_t cos_table_address = 0x200;

/// The address of a named place in its segment, in bytes for 16-bit words. The texture may overlap
/// screen and depth buffer, because no loop uses both.
X86MODEL_INLINE std::int32_t address_of(Symbol symbol) {
  switch (symbol) {
    case Symbol::cos_table:
      return cos_table_address;
    case Symbol::inc_j:
      return 0x70;
    case Symbol::texture:
    case Symbol::screen:
      return 0x100;
    case Symbol::z_buff:
      return 0x500;
    case Symbol::none:
      break;
  }
  return 0;
}

}  // namespace x86model
