/// @file
/// The machine code of the routines, which NASM assembles from `fixproof list`.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "verify/cases/variant.hpp"
#include "verify/machine_code/programs.hpp"

namespace fixproof::machine_code {

/// Returns the machine code of a program, which starts at code_origin: 16-bit code, near-callable,
/// with data addressed from the base of its own segment. Empty without such a program or NASM.
std::span<const std::uint8_t> machine_code(const ProgramKey& key);

/// The same for a loop in one of its forms; its operands are in registers.
std::span<const std::uint8_t> machine_code(const x86model::LoopForm& form);

/// Returns a DOS .COM file that answers lines by calling the routine; empty as above.
std::span<const std::uint8_t> dos_command(const ProgramKey& key);

/// Returns why this build has no machine code; empty if it has.
std::string machine_code_absence();

/// Returns the model's description of a build of FIXED.ASM, for a target other than `standard`.
constexpr x86model::Build model_build(const cases::Build& build) {
  return {.mul_rounding = build.mul_round,
          .div_rounding = build.div_round,
          .chapter_52 = build.chapter_52,
          .repaired = build.repaired};
}
constexpr x86model::Target model_target(cases::Target target) {
  return target == cases::Target::i386 ? x86model::Target::i386 : x86model::Target::i8088;
}

ProgramKey key_of(const cases::Variant& variant);

}  // namespace fixproof::machine_code
