/// @file
/// Instructions and routines as text: NASM's syntax.
#pragma once

#include <string>
#include <string_view>

#include "x86model/loop.hpp"
#include "x86model/routine.hpp"

namespace x86model {

/// "ax" or "eax"; a byte register by its own number: "al".
std::string_view name_of(Register r, Size size);
/// The mnemonic as an assembler spells it.
std::string_view name_of(Mnemonic m);
/// The procedure's name in FIXED.ASM.
std::string_view name_of(Routine r);

/// One instruction, as `neg word [bp+4]`; jumps to labels inside a routine as `jns .FDP1`.
std::string text_of(const Instruction& instruction);

/// The routine as a NASM source file of 16-bit code, with the routines it calls and the table it
/// reads. Near-callable from C: arguments on the stack, result in DX:AX or through the pointers
/// given.
std::string nasm_source(Routine routine, Target target, const Build& build);

/// "loop", "dec-jnz" or "unrolled".
std::string_view name_of(Counting counting);

/// The loop as a NASM source file of 16-bit code: a near procedure that takes its operands in
/// registers, see call_loop.hpp. What an unrolled loop repeats is there once, in %rep.
std::string nasm_source(const LoopForm& form);

}  // namespace x86model
