/// @file
/// The call of a routine: its operands into registers and memory, its results out of them.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "judge/frame.hpp"
#include "judge/image.hpp"

namespace fixproof::judge {

struct Registers {
  std::array<std::uint32_t, x86model::register_count> general{};  ///< in the order of encoding
  std::uint32_t flags = 0;

  [[nodiscard]] std::uint32_t read(const RegisterName& name) const;
  void write(const RegisterName& name, std::uint32_t value);
};

enum class End : std::uint8_t {
  returned,
  divide_error,     ///< #DE
  bad_instruction,  ///< not an instruction, or one of the system's
  bad_address,      ///< memory that is not there
  interrupt,        ///< INT n, or a system call
  port,             ///< IN or OUT
  halted,           ///< HLT
  endless,          ///< no end after Limits of a machine
  fault,            ///< any fault of the host processor but #DE
};

/// How a call ended, and where.
struct Ending {
  End end = End::returned;
  std::uint8_t number = 0;    ///< of the interrupt
  std::uint32_t at = 0;       ///< the instruction's offset in its segment; 0 on the host processor
  std::uint32_t address = 0;  ///< the memory of bad_address
};

/// Sets up calls of one routine and reads what they left.
class Call {
 public:
  /// @param code_selector what a far return address holds
  Call(const Image& image, const Frame& frame, const cases::Variant& variant,
       std::uint16_t code_selector);

  /// Sets up a call: operands, a return address, and noise everywhere else, which depends on
  /// `number` only.
  /// @param words words_in(variant) words
  void enter(std::uint8_t* memory, Registers& registers, std::span<const std::uint32_t> words,
             std::uint64_t number);
  /// Reads words_out(variant) words.
  void leave(const std::uint8_t* memory, const Registers& registers,
             std::span<std::uint32_t> words) const;
  /// Returns the registers that differ from entry and should not: bit r for register r in the order
  /// of encoding. The stack pointer is bit 4.
  [[nodiscard]] unsigned broken(const Registers& left) const;
  /// Returns the registers that differ from entry at all.
  [[nodiscard]] unsigned changed(const Registers& left) const;

 private:
  void push(std::uint8_t* memory, std::uint32_t value, int bytes);
  void push_parameter(std::uint8_t* memory, std::size_t index,
                      std::span<const std::uint32_t> words);

  const Image& image_;
  const Frame& frame_;
  cases::Variant variant_;
  std::vector<Parameter> parameters_;
  std::vector<std::size_t> first_word_;      ///< by parameter: its place in the operands
  std::vector<std::uint32_t> data_offsets_;  ///< by parameter: the number behind its pointer
  std::uint16_t code_selector_;
  int slot_;                  ///< bytes of a pushed word
  std::uint32_t top_ = 0;     ///< offset of the stack's top
  std::uint32_t popped_ = 0;  ///< SP after the return
  Registers entered_;
};

/// Writes and reads little-endian numbers of at most 4 bytes.
void store(std::uint8_t* to, std::uint32_t value, int bytes);
std::uint32_t fetch(const std::uint8_t* from, int bytes);

}  // namespace fixproof::judge
