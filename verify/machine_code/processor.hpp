/// @file
/// Execution of 16-bit code on the host processor.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "verify/machine_code/call_ending.hpp"
#include "verify/machine_code/segment.hpp"

namespace fixproof::machine_code {

/// A segment of 16-bit code, data and stack in this process, and calls into it. x86-64 Linux lets a
/// process create such segments (modify_ldt(2)). The processor runs their code like a 286 or 386 in
/// protected mode, at full speed. One object serves one thread.
class Processor : private boost::noncopyable {
 public:
  /// Returns why this system cannot run 16-bit code; empty if it can.
  static std::string absence();

  /// @param data_bytes the length of the segment of data and stack. By default it ends before the
  ///   code, so only a read with a CS: override reaches a table in the code segment.
  /// @throws std::system_error if the system provides no segment
  explicit Processor(std::size_t data_bytes = caller_origin);
  ~Processor();

  /// Returns the segment. Only the part below caller_origin is writable.
  [[nodiscard]] std::uint8_t* memory() const;

  /// Copies `code` to code_origin.
  /// @throws std::length_error if it does not fit
  /// @throws std::system_error if the system rejects the change of protection
  void load(std::span<const std::uint8_t> code);

  /// Lets its thread call() during its lifetime. It catches faults in the segment and blocks
  /// all other signals, because no handler can run on a 16-bit stack.
  class Calls : private boost::noncopyable {
   public:
    explicit Calls(Processor& processor);
    ~Calls();

    /// Calls the code at code_origin with the registers and flags of `m`, whose SP is at the return
    /// address, as enter() leaves it. Afterwards `m` has the registers of the return or of the
    /// fault; flags are unspecified. A call has no time limit: only this project's listings run
    /// here, and all of them end.
    [[nodiscard]] CallEnding call(SegmentMachine& m) const;

   private:
    struct Saved;
    std::unique_ptr<Saved> saved_;
  };

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace fixproof::machine_code
