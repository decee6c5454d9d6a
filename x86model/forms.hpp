/// @file
/// Which instructions are modelled: those whose form some routine uses.
#pragma once

#include "x86model/routine.hpp"

namespace x86model {

/// Whether some listing for the processor has an instruction of this form: the same mnemonic with
/// operands of the same kinds and sizes. A register and a place in memory are one kind, as in
/// Intel's r/m; a shift by one is a form of its own. The 386 has the 8088's forms too.
bool is_modelled(const Instruction& instruction, Target processor);

}  // namespace x86model
