/// @file
/// Puts the operands of a call into registers and memory, and reads its results from there.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "judge/code/bytes.hpp"
#include "judge/code/call_operands.hpp"
#include "judge/code/frame.hpp"
#include "judge/code/image.hpp"
#include "verify/cases/draw.hpp"
#include "verify/machine_code/x87.hpp"
#include "x86model/flags.hpp"

namespace fixproof::judge {

inline constexpr std::uint32_t direction_flag = 0x400;
inline constexpr std::uint32_t observed_flags = x86model::arithmetic_flags | direction_flag;

/// What a callee of Windows may use above its return address, in bytes.
inline constexpr std::uint32_t bytes_of_home = 32;

/// Bit r is for the register of number r: in the order of encoding, or of the processor's file.
using RegisterMask = std::uint64_t;

/// No processor has more general registers.
inline constexpr std::size_t most_registers = 33;

struct Registers {
  std::array<std::uint64_t, most_registers> general{};  ///< in the order of RegisterMask
  std::uint32_t flags = 0;                              ///< of observed_flags
  machine_code::X87 x87{};                              ///< only after a call
  /// Only after a call: whether DS and SS are those of the image.
  bool has_own_segments = true;

  [[nodiscard]] std::uint64_t read(const RegisterName& name) const;
  /// In 64-bit code, writing 32 bits leaves the upper half as it is: noise.
  void write(const RegisterName& name, std::uint64_t value);
};

enum class End : std::uint8_t {
  returned,
  divide_error,     ///< #DE
  bad_instruction,  ///< an invalid or privileged instruction
  bad_address,      ///< an access to memory that does not exist
  interrupt,        ///< INT n
  system_call,      ///< SYSCALL or SYSENTER
  port,             ///< IN or OUT
  exception,        ///< any other exception of a processor that is not x86
  halted,           ///< HLT
  endless,          ///< no return within the machine's limit of steps or time
  fault,            ///< any other fault on the host processor
};

/// How a call ended, and where.
struct Ending {
  End end = End::returned;
  std::uint8_t number = 0;    ///< of the interrupt or exception
  std::uint32_t at = 0;       ///< the instruction's offset in its segment; 0 on the host processor
  std::uint64_t address = 0;  ///< what bad_address accessed; linear
};

/// Sets up calls of one routine and reads their results.
class Call {
 public:
  /// @param code_selector the selector of far return addresses
  Call(const Image& image, const Frame& frame, const cases::Variant& variant,
       std::uint16_t code_selector);

  /// Sets up a call: operands, a return address, and noise in all other registers, the flags and
  /// the places of results. The noise depends only on `number`.
  /// @param words words_in(variant) words
  void enter(std::uint8_t* memory, Registers& registers, std::span<const std::uint32_t> words,
             std::uint64_t number);
  /// Reads the result of a call into words_out(variant) words.
  void leave(const std::uint8_t* memory, const Registers& registers,
             std::span<std::uint32_t> words) const;
  /// Bits of broken(). Every convention forbids what they say.
  static constexpr RegisterMask sets_direction = RegisterMask{1} << 60U;  ///< DF is set
  /// The x87 stack is not empty.
  static constexpr RegisterMask fills_x87 = RegisterMask{1} << 61U;
  /// The x87 has another control word.
  static constexpr RegisterMask controls_x87 = RegisterMask{1} << 62U;
  /// DS or SS is another one.
  static constexpr RegisterMask moves_segments = RegisterMask{1} << 63U;
  /// Returns the registers that the call should have preserved and did not, with bit r for register
  /// r in the order of encoding, and the bits above. Bit 4 is set if the stack pointer is not what
  /// the convention says.
  [[nodiscard]] RegisterMask broken(const Registers& left) const;
  /// Returns all registers that the call changed, except the stack pointer.
  [[nodiscard]] RegisterMask changed(const Registers& left) const;

 private:
  void load_registers(Registers& registers, std::span<const std::uint32_t> words) const;
  /// Returns the number of words that a parameter takes on the stack.
  [[nodiscard]] int slots_of(const Parameter& p) const;
  void push(std::uint8_t* memory, std::uint64_t value, int bytes);
  void push_parameter(std::uint8_t* memory, std::size_t index,
                      std::span<const std::uint32_t> words);

  const Image& image_;
  const Frame& frame_;
  cases::Variant variant_;
  CallOperands operands_;
  std::vector<Place> results_;  ///< of those in registers
  std::uint16_t code_selector_;
  int slot_;                  ///< size of a pushed word in bytes
  std::uint32_t bottom_ = 0;  ///< offset of the top of the stack before the parameters
  std::uint32_t top_ = 0;     ///< offset of the top of the stack
  std::uint32_t popped_ = 0;  ///< SP after the return
  Registers entered_;
};

}  // namespace fixproof::judge
