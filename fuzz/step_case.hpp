/// @file
/// One instruction as a fuzz input: the processor, eight bytes of code, the flags and the
/// registers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "verify/singlestep/step_machine.hpp"
#include "x86model/decode.hpp"
#include "x86model/routine.hpp"

namespace fixproof::fuzz {

inline constexpr std::size_t max_code_bytes = 8;
/// One byte for the processor, the code, two bytes of flags, and four per register.
inline constexpr std::size_t step_input_size =
    1 + max_code_bytes + 2 + 4 * x86model::register_count;

struct StepCase {
  x86model::Target cpu = x86model::Target::i386;
  std::array<std::uint8_t, max_code_bytes> code{};
  /// Every flag is defined. On an 8088 the upper halves of the registers are 0.
  singlestep::StepMachine machine;

  /// The decoded instruction; nothing if it is invalid, not modelled, uses memory or jumps.
  [[nodiscard]] std::optional<x86model::Decoded> decoded() const;
  /// The `fixproof step` command line that executes `instruction` on this machine.
  [[nodiscard]] std::string replay(const x86model::Instruction& instruction) const;
};

/// Missing bytes are 0.
StepCase read_step_case(std::span<const std::uint8_t> bytes);
void write_step_case(const StepCase& step, std::span<std::uint8_t, step_input_size> bytes);

/// Replaces the instruction by another modelled one, or moves registers to edge cases, or both.
void mutate_step_case(StepCase& step, std::uint32_t seed);

}  // namespace fixproof::fuzz
