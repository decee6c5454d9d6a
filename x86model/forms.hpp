/// @file
/// Which instructions are modelled: those whose form some routine or inner loop uses.
#pragma once

#include <string>
#include <vector>

#include "x86model/loop.hpp"
#include "x86model/routine.hpp"

namespace x86model {

/// Whether some listing for the processor has an instruction of this form: the same mnemonic with
/// operands of the same kinds and sizes. A register and a place in memory are one kind, as in
/// Intel's r/m; a shift by one is a form of its own. The 386 has the 8088's forms too.
bool is_modelled(const Instruction& instruction, Target processor);

/// The form of an instruction in Intel's terms: `imul r/m32`, `shr r/m32, 1`, `jns label`.
std::string form_text(const Instruction& instruction);

/// The forms of the routines for one processor, under any build. Sorted, each once.
std::vector<std::string> form_texts(Target target);

}  // namespace x86model
