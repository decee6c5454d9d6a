/// @file
/// The state an instruction works on: registers, flags and memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "x86model/alu.hpp"
#include "x86model/flags.hpp"
#include "x86model/inline.hpp"
#include "x86model/instruction.hpp"

namespace x86model {

/// The general registers. A dword register holds 2 * WordBits bits; its low half is the word
/// register.
template <int WordBits>
class Registers {
 public:
  [[nodiscard]] X86MODEL_INLINE std::uint32_t read(Register r, Size size) const {
    const std::uint32_t whole = values_[static_cast<std::size_t>(r)];
    return size == Size::word ? whole & alu::mask(WordBits) : whole;
  }

  /// Writing a word register leaves the upper half of the dword register alone.
  X86MODEL_INLINE void write(Register r, Size size, std::uint32_t value) {
    std::uint32_t& whole = values_[static_cast<std::size_t>(r)];
    whole = size == Size::word ? (whole & ~alu::mask(WordBits)) | (value & alu::mask(WordBits))
                               : value & alu::mask(2 * WordBits);
  }

  /// The two 8-bit registers inside ax, cx, dx and bx: AL and AH of ax, and so on.
  [[nodiscard]] constexpr std::uint8_t low_byte(Register r) const {
    return static_cast<std::uint8_t>(read(r, Size::word));
  }
  [[nodiscard]] constexpr std::uint8_t high_byte(Register r) const {
    return static_cast<std::uint8_t>(read(r, Size::word) >> 8U);
  }

  friend constexpr bool operator==(const Registers&, const Registers&) = default;

 private:
  std::array<std::uint32_t, register_count> values_{};
};

/// Memory of machine words, addressed in bytes. Only aligned words inside it exist.
template <int WordBits, std::size_t Words>
class WordMemory {
 public:
  static constexpr std::uint32_t bytes_per_word = WordBits / 8;

  /// @return false where there is no word at `address`.
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

/// A machine with words of `WordBits` bits and the given memory.
template <int WordBits, class MemoryType>
struct Machine {
  static constexpr int word_bits = WordBits;

  Registers<WordBits> registers;
  Flags flags = all_undefined;
  MemoryType memory;
};

/// A byte count or displacement as written for 16-bit words, at this width.
template <int WordBits>
X86MODEL_INLINE std::int32_t scaled_bytes(std::int32_t bytes) {
  return bytes * WordBits / 16;
}

/// Where the cosine table stands, in bytes for 16-bit words.
inline constexpr std::int32_t cos_table_address = 0x200;

}  // namespace x86model
