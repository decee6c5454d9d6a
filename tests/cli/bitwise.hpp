/// @file
/// The instructions as Intel's Software Developer's Manual (volume 2) defines them, worked out one
/// bit at a time: what the model is judged by. Checked itself against the processor it runs on.
#pragma once

#include <cstdint>
#include <string_view>

namespace bitwise {

/// Positions in the FLAGS register.
using Flag = std::uint16_t;
inline constexpr Flag CF = 1U << 0U;
inline constexpr Flag PF = 1U << 2U;
inline constexpr Flag AF = 1U << 4U;
inline constexpr Flag ZF = 1U << 6U;
inline constexpr Flag SF = 1U << 7U;
inline constexpr Flag OF = 1U << 11U;
inline constexpr Flag all_six = CF | PF | AF | ZF | SF | OF;

struct Operands {
  std::uint32_t first = 0;   ///< destination; for MUL, IMUL, DIV and IDIV the accumulator
  std::uint32_t second = 0;  ///< source; for shifts by a count nothing
  int count = 0;             ///< of a shift or rotation, as written
  std::uint32_t high = 0;    ///< upper half of a dividend
  std::uint16_t flags = 0;   ///< before
};

struct Answer {
  std::uint32_t value = 0;      ///< new destination; for CMP the old one
  std::uint32_t high = 0;       ///< upper half of a product, or the remainder
  std::uint16_t flags = 0;      ///< the six after; undefined ones are 0
  std::uint16_t undefined = 0;  ///< which of the six are
  bool fault = false;           ///< #DE
};

/// One instruction on operands of `bits` bits; `name` is one that the model has.
Answer execute(std::string_view name, const Operands& operands, int bits);

}  // namespace bitwise
