/// @file
/// Unicorn, the processor of QEMU as a library, running 16-bit code in real mode.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "machine_code/call_ending.hpp"
#include "machine_code/segment.hpp"

namespace fixproof::machine_code {

/// One emulated processor with a segment at address 0 and `code` at code_origin. Serves one thread.
class Emulator : private boost::noncopyable {
 public:
  /// Why there is none in this build; empty where there is.
  static std::string absence();

  /// What happens between the calls of a batch.
  struct Calls {
    std::size_t count;
    /// Sets up call `i`; SP stands at the return address afterwards, as enter() leaves it.
    std::function<void(std::size_t i, SegmentMachine& m)> enter;
    /// Call `i` has ended; if it returned, in these registers. Flags are unspecified.
    std::function<void(std::size_t i, const SegmentMachine& m, CallEnding ending)> leave;
  };

  /// @throws std::runtime_error where Unicorn refuses
  explicit Emulator(std::span<const std::uint8_t> code);
  ~Emulator();

  /// Makes all these calls. The emulated caller loops, for entering and leaving the emulator takes
  /// far longer than a call; only a fault ends the loop, and it is begun again. A call may take any
  /// number of instructions: only this project's listings run here, and all of them end.
  void run(const Calls& calls);

  /// What is done between two instructions, given the machine with the offset of the next one.
  using Step = std::function<void(SegmentMachine& m, std::uint16_t next)>;

  /// Makes one call, instruction by instruction: `step` before the first one and after every one,
  /// the RET among them. What it changes in registers and flags counts. Flags are those of the
  /// processor.
  /// @param limit instructions after which the call has not ended: CallEnding::fault
  CallEnding trace(SegmentMachine& m, const Step& step, std::size_t limit = 100'000);

  /// The first byte of the segment.
  [[nodiscard]] std::uint8_t* memory() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace fixproof::machine_code
