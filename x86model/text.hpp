/// @file
/// Instructions and routines as text in NASM syntax.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "x86model/loop.hpp"
#include "x86model/routine.hpp"

namespace x86model {

/// "ax" or "eax"; for byte registers, which have their own numbers, "al".
std::string_view name_of(Register r, Size size);
/// The assembler's spelling of the mnemonic.
std::string_view name_of(Mnemonic m);
/// The mnemonic of this spelling, if some routine uses it.
std::optional<Mnemonic> mnemonic_named(std::string_view name);
/// The procedure's name in FIXED.ASM.
std::string_view name_of(Routine r);

/// One instruction, such as `neg word [bp+4]`; a jump inside a routine, such as `jns .FDP1`.
std::string text_of(const Instruction& instruction);

/// The routine as a NASM source file of 16-bit code, with the routines it calls and the table it
/// reads. Near-callable from C: arguments on the stack, result in DX:AX or through pointers.
std::string nasm_source(Routine routine, Target target, const Build& build);

/// "loop", "dec-jnz" or "unrolled".
std::string_view name_of(Counting counting);

/// The loop as a NASM source file of 16-bit code: a near procedure with operands in registers, see
/// call_loop.hpp. The copies of an unrolled loop appear once, in %rep.
std::string nasm_source(const LoopForm& form);

}  // namespace x86model
