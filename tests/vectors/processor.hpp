/// @file
/// One instruction on the processor that the program runs on: an x86-64, whose 16- and 32-bit
/// instructions are those of the 386.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace vectors {

/// The general registers in the order of their encoding, and FLAGS. The machine code that fills and
/// stores them counts on this layout.
struct Registers {
  std::array<std::uint32_t, 8> general{};
  std::uint32_t flags = 0;

  friend bool operator==(const Registers&, const Registers&) = default;
};

/// CF, PF, AF, ZF, SF and OF.
inline constexpr std::uint32_t six_flags = 0x8D5;

/// Whether there is such a processor.
bool has_processor();

/// Executes one instruction, encoded as 64-bit code, on `registers`; of the flags only the six
/// arithmetic ones are the processor's.
/// @return false for a divide error; the registers are then as before
/// @throws std::system_error where the system grants no memory for code
bool execute(std::span<const std::uint8_t> code, Registers& registers);

}  // namespace vectors
