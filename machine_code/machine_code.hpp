/// @file
/// The routines as the bytes that a processor takes: what NASM makes of `fixproof list`.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "cases/variant.hpp"
#include "machine_code/programs.hpp"

namespace fixproof::machine_code {

/// The machine code of a program, its first byte at code_origin: 16-bit code, near-callable, its
/// data addressed from the base of its own segment. Empty where there is no such program, and for
/// all where this was built without NASM.
std::span<const std::uint8_t> machine_code(const ProgramKey& key);

/// As above for a loop in one of its forms; its operands are in registers.
std::span<const std::uint8_t> machine_code(const x86model::LoopForm& form);

/// A DOS program, the contents of a .COM file, that answers lines by calling the routine; empty as
/// above.
std::span<const std::uint8_t> dos_command(const ProgramKey& key);

/// Why there is no machine code in this build; empty where there is.
std::string machine_code_absence();

/// The model's description of a build of FIXED.ASM, for a target other than `standard`.
constexpr x86model::Build model_build(const cases::Build& build) {
  return {.mul_rounding = build.mul_round,
          .div_rounding = build.div_round,
          .chapter_52 = build.chapter_52,
          .repaired = build.repaired};
}
constexpr x86model::Target model_target(cases::Target target) {
  return target == cases::Target::i386 ? x86model::Target::i386 : x86model::Target::i8088;
}

/// The program of a routine of FIXED.ASM at full width.
ProgramKey key_of(const cases::Variant& variant);

}  // namespace fixproof::machine_code
