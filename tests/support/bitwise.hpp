/// @file
/// The reference for the model: the instructions as Intel's Software Developer's Manual, volume 2,
/// defines them, computed bit by bit. silicon_test.cpp checks it against the host processor.
#pragma once

#include <cstdint>
#include <string_view>

namespace bitwise {

/// Bit masks of the FLAGS register.
using Flag = std::uint16_t;
inline constexpr Flag CF = 1U << 0U;
inline constexpr Flag PF = 1U << 2U;
inline constexpr Flag AF = 1U << 4U;
inline constexpr Flag ZF = 1U << 6U;
inline constexpr Flag SF = 1U << 7U;
inline constexpr Flag OF = 1U << 11U;
inline constexpr Flag all_six = CF | PF | AF | ZF | SF | OF;

struct Operands {
  std::uint32_t first = 0;   ///< destination; the accumulator for MUL, IMUL, DIV and IDIV
  std::uint32_t second = 0;  ///< source; unused in shifts by a count
  int count = 0;             ///< count of a shift or rotation, as written
  std::uint32_t high = 0;    ///< upper half of a dividend
  std::uint16_t flags = 0;   ///< before the instruction
};

struct Answer {
  std::uint32_t value = 0;      ///< new destination; the old one for CMP
  std::uint32_t high = 0;       ///< upper half of a product, or the remainder
  std::uint16_t flags = 0;      ///< the six flags after the instruction; undefined ones are 0
  std::uint16_t undefined = 0;  ///< mask of the undefined ones among the six
  bool fault = false;           ///< #DE
};

/// Executes one instruction on operands of `bits` bits. `name` is a mnemonic of the model.
Answer execute(std::string_view name, const Operands& operands, int bits);

}  // namespace bitwise
