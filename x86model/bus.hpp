/// @file
/// How many bytes a run moves over the 8-bit bus of an 8088, and how long that takes.
///
/// Intel's tables count code as already fetched. An 8088 has a bus unit, which fetches code into a
/// queue of four bytes, and an execution unit, which takes the clocks of the tables; they work at
/// the same time. Each byte on the bus takes four clocks. So a run takes at least the larger of two
/// times: the table time, which includes the transfers of operands because the execution unit waits
/// for them, and the bus time, which is all bytes of code and operands times four.
///
/// The bus time leaves out the bytes that are fetched behind a taken jump and then discarded, wait
/// states and the refresh of memory. It is a lower bound for that reason.
///
/// Other processors have no bus time here. A 286 and a 386 move 2 and 4 bytes in two clocks without
/// wait states: less time than the tables for each routine. How many wait states there are is a
/// matter of the board. A 486 has the code in its cache.
#pragma once

#include <cstdint>

#include "x86model/instruction.hpp"

namespace x86model {

inline constexpr std::uint64_t bus_clocks_a_byte = 4;

/// Bytes that pass over the bus.
struct BusBytes {
  std::uint64_t code = 0;  ///< of the instructions that are executed
  std::uint64_t data = 0;  ///< operands in memory, the stack and return addresses, read and written

  [[nodiscard]] constexpr std::uint64_t clocks() const { return bus_clocks_a_byte * (code + data); }
  constexpr BusBytes& operator+=(const BusBytes& other) {
    code += other.code;
    data += other.data;
    return *this;
  }
  friend constexpr bool operator==(const BusBytes&, const BusBytes&) = default;
};

/// The bytes of one execution. They do not depend on the state of the machine: a conditional jump
/// moves no data whether it is taken or not.
BusBytes bus_bytes(const Instruction& instruction);

}  // namespace x86model
