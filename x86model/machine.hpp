/// @file
/// A machine of words: registers, flags and memory, and the operands of instructions in them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "x86model/flags.hpp"
#include "x86model/inline.hpp"
#include "x86model/instruction.hpp"
#include "x86model/memory.hpp"
#include "x86model/words.hpp"

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
    return static_cast<std::uint16_t>(value & mask(WordBits));
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

/// An immediate in code of words of `WordBits` bits.
template <int WordBits>
X86MODEL_INLINE std::uint32_t immediate(const Operand& o) {
  switch (o.scaling) {
    case Scaling::literal:
      break;
    case Scaling::bytes:
      return static_cast<std::uint32_t>(scaled_bytes<WordBits>(o.value));
    case Scaling::half_unit:
      return std::uint32_t{1} << (WordBits - 1);
    case Scaling::word_bits:
      return WordBits;
  }
  return static_cast<std::uint32_t>(o.value);
}

/// A machine with words of `WordBits` bits and the given memory. Reads and writes of operands
/// return false if an address is not in memory.
template <int WordBits, class MemoryType>
struct Machine {
  using Domain = Words;
  static constexpr int word_bits = WordBits;

  Registers<WordBits> registers;
  Flags flags = all_undefined;
  MemoryType memory;

  X86MODEL_INLINE static Words domain() { return {}; }
  X86MODEL_INLINE static int bits_of(Size size) {
    if (size == Size::byte) return 8;
    return size == Size::word ? WordBits : 2 * WordBits;
  }
  X86MODEL_INLINE static std::uint32_t count_in(const Operand& o) { return immediate<WordBits>(o); }
  /// Whether the instruction raises #DE, for its machine of numbers: if the condition holds.
  X86MODEL_INLINE static bool faults_if(bool condition) { return condition; }

  [[nodiscard]] X86MODEL_INLINE std::uint32_t read(Register r, Size size) const {
    return registers.read(r, size);
  }
  X86MODEL_INLINE void write(Register r, Size size, std::uint32_t value) {
    registers.write(r, size, value);
  }

  /// Reads `size` bits at an operand into `value`.
  X86MODEL_INLINE bool read(const Operand& o, Size size, std::uint32_t& value) const {
    if (o.kind == Operand::Kind::reg) {
      value = registers.read(o.reg, size);
      return true;
    }
    if (o.kind == Operand::Kind::immediate) {
      value = immediate<WordBits>(o) & mask(bits_of(size));
      return true;
    }
    const std::uint32_t address = address_in(o);
    if (size == Size::byte) {
      if constexpr (has_bytes) {
        return o.segment == SegmentOverride::none && memory.read_byte(address, value);
      }
      return false;
    }
    if (!read_word(o, address, value)) return false;
    if (size == Size::word) return true;
    std::uint32_t high = 0;
    if (!read_word(o, address + word_bytes, high)) return false;
    value |= high << WordBits;
    return true;
  }

  X86MODEL_INLINE bool write(const Operand& o, Size size, std::uint32_t value) {
    if (o.kind == Operand::Kind::reg) {
      registers.write(o.reg, size, value);
      return true;
    }
    // The code segment is not writable.
    if (o.segment != SegmentOverride::none) return false;
    const std::uint32_t address = address_in(o);
    if (size == Size::byte) {
      if constexpr (has_bytes) return memory.write_byte(address, value);
      return false;
    }
    if (!memory.write(address, value)) return false;
    return size == Size::word || memory.write(address + word_bytes, value >> WordBits);
  }

  X86MODEL_INLINE bool push(std::uint32_t value) {
    const std::uint32_t top = (read(Register::sp, Size::word) - word_bytes) & mask(WordBits);
    if constexpr (requires { memory.write_stack(top, value); }) {
      if (!memory.write_stack(top, value)) return false;
    } else {
      if (!memory.write(top, value)) return false;
    }
    write(Register::sp, Size::word, top);
    return true;
  }

  /// The word at the top of the stack.
  X86MODEL_INLINE bool read_top(std::uint32_t& value) const {
    const std::uint32_t top = read(Register::sp, Size::word);
    if constexpr (requires { memory.read_stack(top, value); }) {
      return memory.read_stack(top, value);
    } else {
      return memory.read(top, value);
    }
  }

  X86MODEL_INLINE bool pop(std::uint32_t& value) {
    if (!read_top(value)) return false;
    write(Register::sp, Size::word, read(Register::sp, Size::word) + word_bytes);
    return true;
  }

  /// STOSB and STOSW in 16-bit code: stores AL or AX at ES:DI and advances DI. Does not change
  /// flags.
  X86MODEL_INLINE bool store_string(Size size) {
    if constexpr (has_bytes) {
      const std::uint32_t to = read(Register::di, Size::word);
      const std::uint32_t value = read(Register::ax, Size::word);
      const bool done = size == Size::byte ? memory.write_extra_byte(to, value)
                                           : memory.write_extra_word(to, value);
      if (done) write(Register::di, Size::word, to + (size == Size::byte ? 1 : 2));
      return done;
    }
    return false;
  }

 private:
  static constexpr std::uint32_t word_bytes = WordBits / 8;
  /// Whether the memory has bytes and segments; see ByteMemory.
  static constexpr bool has_bytes = requires(MemoryType m, std::uint32_t value) {
    m.read_byte(value, value);
    m.write_byte(value, value);
    m.write_extra_byte(value, value);
    m.write_extra_word(value, value);
  };

  [[nodiscard]] X86MODEL_INLINE std::uint32_t address_in(const Operand& o) const {
    const std::int32_t displacement = o.value + address_of(o.symbol);
    if constexpr (WordBits == 16) {
      const auto constant = static_cast<std::uint32_t>(displacement);
      if (o.addressing == Addressing::direct) return constant & mask(16);
      if (o.addressing != Addressing::base) {
        const std::uint32_t index = registers.read(o.reg, Size::dword);
        return (o.addressing == Addressing::index_twice ? 2 * index : index) + constant;
      }
    }
    const auto base = registers.read(o.reg, Size::word);
    return (base + static_cast<std::uint32_t>(scaled_bytes<WordBits>(displacement))) &
           mask(WordBits);
  }

  /// The word at `address` in the segment of operand `o`. A memory without `read_code` has no data
  /// in its code segment.
  X86MODEL_INLINE bool read_word(const Operand& o, std::uint32_t address,
                                 std::uint32_t& value) const {
    if (o.segment == SegmentOverride::none) return memory.read(address, value);
    if constexpr (requires { memory.read_code(address, value); }) {
      return memory.read_code(address, value);
    }
    return false;
  }
};

}  // namespace x86model
