/// @file
/// Runs one instruction on the host processor, an x86-64, whose 16- and 32-bit instructions are
/// those of the 386.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace vectors {

/// The general registers in encoding order, and FLAGS. The machine code that loads and stores them
/// depends on this layout.
struct Registers {
  std::array<std::uint32_t, 8> general{};
  std::uint32_t flags = 0;

  friend bool operator==(const Registers&, const Registers&) = default;
};

/// CF, PF, AF, ZF, SF and OF.
inline constexpr std::uint32_t six_flags = 0x8D5;

/// Whether the host is such a processor.
bool has_processor();

/// Executes one instruction, encoded as 64-bit code, on `registers`. Only the six arithmetic flags
/// come from the processor.
/// @return false for a divide error, with `registers` unchanged
/// @throws std::system_error if the system grants no memory for code
bool execute(std::span<const std::uint8_t> code, Registers& registers);

}  // namespace vectors
