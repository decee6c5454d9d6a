/// @file
/// The clocks of one instruction that stands alone.
#pragma once

#include <optional>

#include "singlestep/step_machine.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::singlestep {

/// What `instruction` takes on `cpu`, about to be executed in the state of `before`. A conditional
/// jump is not taken. JMP is, to any instruction of the listings that the processor runs: the range
/// is that of what it may lead to.
/// @return nothing where the processor does not have the instruction
std::optional<x86model::Range> step_clocks(x86model::Cpu cpu,
                                           const x86model::Instruction& instruction,
                                           const StepMachine& before);

}  // namespace fixproof::singlestep
