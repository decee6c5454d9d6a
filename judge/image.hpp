/// @file
/// A user's code, laid out in memory for a call.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace fixproof::judge {

struct Symbol {
  std::string name;
  std::uint32_t offset = 0;  ///< in the code segment
};

/// A routine and the memory around it. Addresses in `memory` are linear; a segment starts at 16
/// times its number. Flat code has segment 0 everywhere.
struct Image {
  int bits = 16;
  std::string container;             ///< such as "flat binary", for people
  std::vector<std::uint8_t> memory;  ///< all that the routine can reach
  std::uint32_t first = 0;           ///< linear address of the first byte of the file
  std::uint32_t end = 0;             ///< linear address after the last
  std::uint16_t code_segment = 0;
  std::uint16_t data_segment = 0;  ///< of data and stack
  std::uint32_t entry = 0;         ///< in the code segment
  std::uint32_t entry_end = 0;     ///< after the routine; 0 if unknown
  std::vector<Symbol> symbols;

  std::uint32_t stack_top = 0;  ///< in the data segment: arguments are below
  std::uint32_t data = 0;       ///< in the data segment: what pointers point to
  std::uint32_t exit = 0;       ///< in the code segment: where the routine returns to

  [[nodiscard]] std::uint32_t linear(std::uint16_t segment, std::uint32_t offset) const {
    return 16U * segment + offset;
  }
  [[nodiscard]] std::uint32_t code_at(std::uint32_t offset) const {
    return linear(code_segment, offset);
  }
  [[nodiscard]] std::uint32_t data_at(std::uint32_t offset) const {
    return linear(data_segment, offset);
  }
};

/// What fills memory outside the file: HLT, so that code that goes astray ends there.
inline constexpr std::uint8_t unused = 0xF4;

/// Room for the operands and results that pointers point to, in bytes.
inline constexpr std::uint32_t data_bytes = 0x80;
/// Room for the stack.
inline constexpr std::uint32_t stack_bytes = 0xC00;
/// Room for the code that a routine returns to.
inline constexpr std::uint32_t exit_bytes = 0x10;

}  // namespace fixproof::judge
