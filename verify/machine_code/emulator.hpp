/// @file
/// The Unicorn emulator (QEMU's processor as a library), running 16-bit code in real mode.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include "verify/machine_code/call_ending.hpp"
#include "verify/machine_code/segment.hpp"

namespace fixproof::machine_code {

/// Unicorn itself failed, which says nothing about the code that it ran.
class EmulatorError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An emulated processor with a segment at address 0 and `code` at code_origin. Serves one thread.
class Emulator : private boost::noncopyable {
 public:
  /// Returns why this build has no emulator; empty if it has one.
  static std::string absence();
  /// Returns the version of the Unicorn library that runs here, for example `2.0.1`.
  static std::string version();

  struct Calls {
    std::size_t count;
    /// Sets up call `i`. It leaves SP at the return address, as x86model/call.hpp does.
    std::function<void(std::size_t i, SegmentMachine& m)> enter;
    /// Handles the end of call `i`. The registers are valid if it returned; flags are unspecified.
    std::function<void(std::size_t i, const SegmentMachine& m, CallEnding ending)> leave;
  };

  /// @throws EmulatorError if Unicorn fails, or if less memory is left than it needs
  explicit Emulator(std::span<const std::uint8_t> code);
  ~Emulator();

  /// Makes all calls. The emulated caller loops, because entering the emulator takes far longer
  /// than a call; only a fault leaves the loop. A call has no instruction limit: only this
  /// project's listings run here, and all of them end.
  /// @throws EmulatorError
  void run(const Calls& calls);

  /// A callback between two instructions; `next` is the offset of the second.
  using Step = std::function<void(SegmentMachine& m, std::uint16_t next)>;

  /// Makes one call and runs `step` before the first instruction and after every one, including
  /// RET. The step can change registers and flags. The flags are those of the processor.
  /// @param limit the maximum number of instructions; beyond it the call ends in CallEnding::fault
  /// @throws EmulatorError
  CallEnding trace(SegmentMachine& m, const Step& step, std::size_t limit = 100'000);

  [[nodiscard]] std::uint8_t* memory() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace fixproof::machine_code
