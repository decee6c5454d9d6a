/// @file
/// The clocks of a single instruction.
#pragma once

#include <optional>

#include "verify/singlestep/step_machine.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::singlestep {

/// Returns the clocks of `instruction` on `cpu` in the state `before` its execution. A conditional
/// jump counts as not taken. JMP counts as taken to any instruction of the listings that the
/// processor supports, so the result is a range.
/// @return nothing if the processor does not support the instruction
std::optional<x86model::Range> step_clocks(x86model::Cpu cpu,
                                           const x86model::Instruction& instruction,
                                           const StepMachine& before);

}  // namespace fixproof::singlestep
