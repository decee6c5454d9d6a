/// @file
/// What an instruction of an AVR accesses, and whether it may run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fixproof::judge::avr {

// Where the data space has what is no memory: the registers, and from `first_port` on those that IN
// and OUT reach. The last of these are of the core.
inline constexpr std::size_t registers = 32;
inline constexpr std::uint32_t first_port = 0x20;
inline constexpr std::uint32_t rampz = 0x5B;
inline constexpr std::uint32_t eind = 0x5C;
inline constexpr std::uint32_t low_stack_pointer = 0x5D;
inline constexpr std::uint32_t first_memory = 0x60;

/// The state of an AVR that decides what an instruction accesses.
struct State {
  std::uint16_t word = 0;           ///< the instruction
  std::uint16_t next = 0;           ///< the word after it
  std::span<const std::uint8_t> r;  ///< the 32 registers
  std::uint16_t stack = 0;          ///< SP
  std::uint8_t high_z = 0;          ///< RAMPZ: the bits above Z of ELPM
  int return_bytes = 2;
};

struct Reach {
  enum class Kind : std::uint8_t {
    none,
    data,     ///< bytes of the data space
    program,  ///< a byte of the code
    halt,     ///< SLEEP and BREAK wait for what is not there
    invalid,  ///< not defined, or a loader's
  };
  Kind kind = Kind::none;
  std::uint32_t address = 0;
  std::uint32_t bytes = 0;
  bool is_write = false;
};

Reach reach_of(const State& state);

}  // namespace fixproof::judge::avr
