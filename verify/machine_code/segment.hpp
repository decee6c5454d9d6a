/// @file
/// The 64 KiB segment that machine code runs in, as a machine for x86model/call.hpp.
#pragma once

#include <cstddef>
#include <cstdint>

#include "verify/machine_code/programs.hpp"
#include "x86model/machine.hpp"

namespace fixproof::machine_code {

inline constexpr std::size_t segment_size = 0x10000;
/// The unit of memory protection, and of translated code in emulators.
inline constexpr std::size_t page_size = 0x1000;

/// The offset of the routine's caller, which has its own page below the routine.
inline constexpr std::uint16_t caller_origin = code_origin - page_size;

/// A view of memory as little-endian 16-bit words. It does not own the memory.
class SegmentMemory {
 public:
  explicit SegmentMemory(std::uint8_t* first) : first_(first) {}

  /// @return false if the word ends outside the segment
  bool read(std::uint32_t address, std::uint32_t& value) const {
    if (address > segment_size - 2) return false;
    value = static_cast<std::uint32_t>(first_[address] | first_[address + 1] << 8);
    return true;
  }
  bool write(std::uint32_t address, std::uint32_t value) {
    if (address > segment_size - 2) return false;
    first_[address] = static_cast<std::uint8_t>(value);
    first_[address + 1] = static_cast<std::uint8_t>(value >> 8U);
    return true;
  }

 private:
  std::uint8_t* first_;
};

/// The machine that enter() and leave() of x86model/call.hpp work on.
struct SegmentMachine : x86model::Machine<16, SegmentMemory> {
  explicit SegmentMachine(std::uint8_t* first)
      : Machine{{}, x86model::all_undefined, SegmentMemory(first)} {}
};

}  // namespace fixproof::machine_code
