/// @file
/// The forms of instructions that the model implements: those of some routine or inner loop.
#pragma once

#include <string>
#include <vector>

#include "x86model/flags.hpp"
#include "x86model/loop.hpp"
#include "x86model/routine.hpp"

namespace x86model {

/// Whether some listing for the processor uses this form: the same mnemonic with operands of the
/// same kinds and sizes. Registers and memory operands are one kind, as in Intel's r/m; a shift by
/// one is a separate form. The 386 includes the 8088's forms.
bool is_modelled(const Instruction& instruction, Target processor);

/// The form of an instruction in Intel's terms: `imul r/m32`, `shr r/m32, 1`, `jns label`.
std::string form_text(const Instruction& instruction);

/// The forms of the routines for one processor, under all builds, sorted and without duplicates.
std::vector<std::string> form_texts(Target target);

/// An instruction of every form of the routines and loops for both processors, in the order of
/// Mnemonic. Here a register and memory are two forms.
std::vector<Instruction> form_examples();

/// The flags that execute.hpp reads and changes for this instruction, seen by executing it.
FlagUse flag_use(const Instruction& instruction);

}  // namespace x86model
