/// @file
/// The instructions that users' code has and no listing, from Intel's Software Developer's Manual,
/// volume 2: one meaning each.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "judge/code/execution.hpp"

namespace fixproof::judge {

/// An instruction with its number of operands. A meaning throws Obstacle for a form that is not
/// modelled.
struct UserInstruction {
  std::string_view mnemonic;  ///< as Intel spells it; `setcc` and `cmovcc` for all conditions
  std::size_t operands;
  void (*meaning)(const Execution& e);
};

/// Returns all of them.
std::span<const UserInstruction> user_instructions();

/// Returns the row of an instruction, or null.
const UserInstruction* user_instruction(std::string_view mnemonic, std::size_t operands);

// The meanings, by kind.

namespace meaning {

using Meaning = void(const Execution& e);

/// Shifts by a count that depends on operands, and rotates by any count.
Meaning shl, shr, sar, rol, ror, rcl, rcr, shld, shrd, shlx, shrx, sarx, rorx;

/// Products and quotients of all sizes that listings lack.
Meaning mul, imul, imul_to_register, mulx, div, idiv;

/// Instructions on single bits.
Meaning bt, bts, btr, btc, bsf, bsr, tzcnt, lzcnt, popcnt, bswap, andn, blsr, blsi, blsmsk;

}  // namespace meaning

}  // namespace fixproof::judge
