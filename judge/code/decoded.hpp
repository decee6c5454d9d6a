/// @file
/// Instructions of users' code, decoded by Zydis.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/code/frame.hpp"
#include "x86model/alu.hpp"
#include "x86model/flags.hpp"
#include "x86model/instruction.hpp"

namespace fixproof::judge {

struct Operand {
  enum class Kind : std::uint8_t {
    reg,
    segment,
    immediate,
    memory,
    other,  ///< such as a far pointer or a register of the x87
  };

  Kind kind = Kind::other;
  RegisterName reg{};                 ///< if it is a register
  std::uint64_t value = 0;            ///< immediate or displacement, sign-extended
  std::vector<RegisterName> bases{};  ///< registers; their sum with `value` is the address
  int scale = 1;                      ///< what the last of two bases, or the only one, is times
  x86model::Size size = x86model::Size::none;  ///< set by symbolic.cpp, for x86model/execute.hpp
  int bits = 0;                                ///< its own size
  int address_bits = 0;                        ///< of memory
};

struct Decoded {
  std::string mnemonic;  ///< as Intel spells it, RETF for a far return; empty if it is invalid
  std::vector<Operand> operands;                          ///< those that an assembler writes
  std::optional<x86model::alu::ConditionCode> condition;  ///< of a jump, SETcc or CMOVcc
  std::optional<std::uint32_t> target;  ///< of a near jump or call, if it is fixed
  x86model::FlagUse flags;
  std::uint32_t bytes = 0;
  int width = 0;                    ///< of its operands; of a byte's, as the prefix says
  std::uint8_t opcode = 0;          ///< the byte after the prefixes and 0F
  int prefixes = 0;                 ///< of any kind
  int components = 0;               ///< as a 386 counts them at the target of a jump
  bool has_repeat = false;          ///< REP, REPE or REPNE
  bool overrides_segment = false;   ///< by a prefix
  bool is_privileged = false;       ///< for an operating system only; no IN or OUT
  bool needs_386 = false;           ///< its opcode, a prefix, or FS or GS
  bool uses_accumulator = false;    ///< the short form with AL, AX or EAX
  bool has_displacement = false;    ///< of a memory operand
  bool has_wide_addresses = false;  ///< 32 bits: LOOP counts in ECX
  /// The registers that it writes, a bit each, but not SP as the stack pointer.
  unsigned writes = 0;
};

/// Decodes the first instruction of `bytes`.
/// @param at   its offset in the code segment
/// @param bits 16, 32 or 64, the width of the code
Decoded decoded(std::span<const std::uint8_t> bytes, std::uint32_t at, int bits);

/// Tells whether it is a conditional jump on flags.
bool is_conditional(const Decoded& instruction);
/// Tells whether it is a jump that may not be taken.
bool may_pass(const Decoded& instruction);
/// Tells whether execution never goes on to the next instruction in memory: after JMP, a return,
/// HLT or a byte that is no instruction.
bool ends_flow(const Decoded& instruction);

}  // namespace fixproof::judge
