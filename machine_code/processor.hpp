/// @file
/// The processor this runs on, made to run 16-bit code.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "machine_code/call_ending.hpp"
#include "machine_code/segment.hpp"

namespace fixproof::machine_code {

/// A segment of 16-bit code, data and stack in this process, and calls into it. x86-64 Linux still
/// lets a process make such segments (modify_ldt(2)); the processor then runs the code as a 286 or
/// 386 in protected mode does, at full speed. One object serves one thread.
class Processor : private boost::noncopyable {
 public:
  /// Why there is no such processor here; empty where there is.
  static std::string absence();

  /// @param data_bytes the length of the segment of data and stack. By default it ends before the
  /// code, so only a read with a CS: override reaches a table in the code segment.
  /// @throws std::system_error where the system gives no segment
  explicit Processor(std::size_t data_bytes = caller_origin);
  ~Processor();

  /// The first byte of the segment. Below caller_origin it may be written.
  [[nodiscard]] std::uint8_t* memory() const;

  /// Puts `code` at code_origin.
  /// @throws std::length_error for what does not fit; std::system_error where the system refuses
  void load(std::span<const std::uint8_t> code);

  /// While one lives, its thread may call(): faults in the segment are caught, and signals meant
  /// for the process wait, for no handler could run on a 16-bit stack.
  class Calls : private boost::noncopyable {
   public:
    explicit Calls(Processor& processor);
    ~Calls();

    /// Calls what stands at code_origin with the registers and flags of `m`, whose SP stands at the
    /// return address as enter() has left it. Afterwards `m` has the registers that the routine
    /// left, and unless it returned, those of the fault; flags are unspecified. Waits for the
    /// routine however long it takes: only this project's listings run here, and all of them end.
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
