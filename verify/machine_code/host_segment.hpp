/// @file
/// Execution of a user's code, of 16 or 32 bits, on the host processor.
#pragma once

#include <array>
#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "verify/machine_code/call_ending.hpp"
#include "verify/machine_code/x87.hpp"

namespace fixproof::machine_code {

/// One segment with the code, data and stack of a user, in this process. The processor keeps the
/// code in the segment as long as it loads no other selector. It may load those of the system: 2Bh
/// for data in all of the low 4 GiB, and 33h for 64-bit code, which Linux gives to every process.
/// Both need a linear address. The segment's is random, and neither its memory nor the registers
/// tell it: the way back leads through a segment that may only be executed. A wrong guess is a
/// fault. Everything else that the code may do is up to the process: call it only in one that may
/// neither open files nor run forever.
///
/// While an object lives, its thread blocks all signals but faults, because no handler can run on
/// the code's stack.
class HostSegment : private boost::noncopyable {
 public:
  /// Returns why this system cannot run such code; empty if it can.
  static std::string absence();

  /// @param bits  16 or 32
  /// @param bytes the length of the segment: at most 64 KiB for 16 bits, 1 MiB for 32
  /// @throws std::system_error if the system provides no segment
  HostSegment(int bits, std::size_t bytes);
  ~HostSegment();

  /// Returns the segment, all of which the code may write and execute.
  [[nodiscard]] std::uint8_t* memory() const;
  /// Returns what CS holds while the code runs.
  [[nodiscard]] std::uint16_t code_selector() const;

  /// The number of bytes of put_exit().
  static constexpr std::size_t exit_bytes = 8;
  /// Writes code at `offset` that ends a call: the address to which the user's code returns.
  void put_exit(std::uint32_t offset) const;

  /// The general registers in the order of their encoding, and the flags.
  struct Registers {
    std::array<std::uint32_t, 8> general{};
    std::uint32_t flags = 0;
    X87 x87{};  ///< only after a call; every call starts as in a new process
  };
  /// Jumps to `entry`. The registers become those at the exit or at the fault.
  [[nodiscard]] CallEnding call(Registers& registers, std::uint32_t entry) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace fixproof::machine_code
