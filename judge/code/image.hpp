/// @file
/// A user's code, laid out in memory for a call.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "judge/code/architecture.hpp"

namespace fixproof::judge {

struct Symbol {
  std::string name;
  std::uint32_t offset = 0;  ///< offset in the code segment

  /// An address that is nearer to a missing symbol than this belongs to it.
  static constexpr std::uint32_t reach = 0x8000;
};

/// Memory at a place of its own, such as the RAM of a microcontroller.
struct Region {
  std::uint32_t address = 0;
  std::vector<std::uint8_t> bytes;
};

/// A routine and the memory around it. Addresses in `memory` are linear; a segment starts at 16
/// times its number. Flat code has segment 0 everywhere.
struct Image {
  int bits = 16;
  const Architecture* architecture = nullptr;  ///< a processor other than x86
  bool has_assumed_bits = false;     ///< whether neither the user nor the file tells the width
  std::string container;             ///< for messages, such as "flat binary"
  std::vector<std::uint8_t> memory;  ///< everything that the routine can reach
  std::uint32_t base = 0;            ///< linear address of `memory`; not 0 in a linked program
  std::uint32_t first = 0;           ///< linear address of the first byte of the file
  std::uint32_t end = 0;             ///< linear address after its last byte
  std::uint32_t reserved = 0;        ///< linear address after what the file reserves behind it
  std::uint16_t code_segment = 0;
  std::uint16_t data_segment = 0;  ///< segment of data and stack
  std::uint32_t entry = 0;         ///< offset in the code segment
  std::uint32_t entry_mode = 0;    ///< bit 0 for Thumb code
  std::uint32_t entry_end = 0;     ///< offset after the routine; 0 if unknown
  std::vector<Symbol> symbols;
  std::vector<Symbol> hidden{};  ///< static functions of a linked file; names may be there twice
  std::vector<Symbol> missing;   ///< names that an object lacks, at addresses without memory

  std::vector<Region> regions{};  ///< memory of the file that is far from `memory`
  std::vector<Symbol> bases{};    ///< the values of symbols that registers point to

  std::uint32_t stack_top = 0;  ///< offset in the data segment; arguments are below it
  std::uint32_t data = 0;       ///< offset in the data segment of what pointers point to
  std::uint32_t exit = 0;       ///< offset in the code segment of where the routine returns to

  [[nodiscard]] bool is_big_endian() const {
    return architecture != nullptr && architecture->is_big_endian;
  }
  /// Returns the missing name that an address belongs to, or null.
  [[nodiscard]] const Symbol* missing_at(std::uint64_t address) const {
    for (const Symbol& symbol : missing) {
      if (address - symbol.offset + Symbol::reach < 2 * Symbol::reach) return &symbol;
    }
    return nullptr;
  }

  [[nodiscard]] static std::uint32_t linear(std::uint16_t segment, std::uint32_t offset) {
    return 16U * segment + offset;
  }
  /// Returns where in `memory` a linear address is; an index beyond its end for any other address.
  [[nodiscard]] std::uint32_t index_of(std::uint32_t address) const { return address - base; }
  [[nodiscard]] std::uint32_t code_at(std::uint32_t offset) const {
    return linear(code_segment, offset);
  }
  [[nodiscard]] std::uint32_t data_at(std::uint32_t offset) const {
    return linear(data_segment, offset);
  }
};

/// Returns what the code of another processor than x86 is for, such as "Thumb" or "AArch64".
/// @pre image.architecture is not null
inline std::string_view code_name(const Image& image) {
  return image.entry_mode == 1 ? "Thumb" : image.architecture->name;
}

/// What `container` says of code without a header, and of an ELF file before and after linking.
inline constexpr const char* flat_container = "flat binary";
inline constexpr const char* object_container = "ELF object";
inline constexpr const char* linked_container = "linked ELF file";
/// What `container` says of a program in DOS's format with relocations.
inline constexpr const char* exe_container = "MZ .EXE";

/// Fills the memory outside the file: HLT, so that stray code ends there.
inline constexpr std::uint8_t unused = 0xF4;
/// The same for other processors: an instruction that none of them has.
inline constexpr std::uint8_t unused_elsewhere = 0xFF;

/// Bytes for the operands and results that pointers point to.
inline constexpr std::uint32_t data_bytes = 0x80;
/// Bytes for the stack.
inline constexpr std::uint32_t stack_bytes = 0xC00;
/// Bytes for the code that a routine returns to.
inline constexpr std::uint32_t exit_bytes = 0x10;

}  // namespace fixproof::judge
