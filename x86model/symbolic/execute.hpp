/// @file
/// Executes one instruction of a symbolic run.
#pragma once

#include "x86model/execute.hpp"
#include "x86model/symbolic/operands.hpp"

namespace x86model::symbolic {

/// Executes an instruction that is neither control flow nor a divide, which may split the path.
/// @return proceeds, or the reason why not
Outcome execute(Terms& terms, const Operands& operands, Thread& thread,
                const Instruction& instruction);

}  // namespace x86model::symbolic
