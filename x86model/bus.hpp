/// @file
/// The bytes that a run moves over the 8-bit bus of an 8088, and the time that takes.
///
/// Intel's tables assume that code is already fetched. In an 8088, a bus unit fetches code into a
/// queue of four bytes while an execution unit takes the clocks of the tables. Each byte on the bus
/// takes four clocks. A run therefore takes at least the larger of two times: the table time, which
/// includes operand transfers because the execution unit waits for them, and the bus time, which is
/// four clocks per byte of code and operands.
///
/// The bus time is a lower bound: it omits discarded prefetches after taken jumps, wait states and
/// memory refresh.
///
/// Other processors have no bus time here. Without wait states, a 286 moves 2 bytes and a 386 4
/// bytes in two clocks, which is less than the table time of every routine. Wait states depend on
/// the board. A 486 runs from its cache.
#pragma once

#include <cstdint>

#include "x86model/instruction.hpp"

namespace x86model {

inline constexpr std::uint64_t bus_clocks_per_byte = 4;

/// The bytes that pass over the bus.
struct BusBytes {
  std::uint64_t code = 0;  ///< of the executed instructions
  std::uint64_t data = 0;  ///< memory operands, the stack and return addresses, read and written

  [[nodiscard]] constexpr std::uint64_t clocks() const {
    return bus_clocks_per_byte * (code + data);
  }
  constexpr BusBytes& operator+=(const BusBytes& other) {
    code += other.code;
    data += other.data;
    return *this;
  }
  friend constexpr bool operator==(const BusBytes&, const BusBytes&) = default;
};

/// The bytes of one execution. They do not depend on the machine state: a conditional jump moves no
/// data, taken or not.
BusBytes bus_bytes(const Instruction& instruction);

}  // namespace x86model
