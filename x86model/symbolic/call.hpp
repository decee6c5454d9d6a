/// @file
/// The call of a routine with symbolic operands, with the memory layout of x86model/call.hpp.
#pragma once

#include <string>
#include <vector>

#include "x86model/routine.hpp"
#include "x86model/symbolic/run.hpp"

namespace x86model::symbolic {

/// The name of operand `index`: a and b; angle; x0 ... x11, v0 ... v2 for XformVec; p0 ... p11, q0
/// ... q11 for ConcatXforms.
std::string operand_name(Routine routine, int index);

/// The machine at the routine's first instruction. Operands are variables of these names, 32 bits
/// each, 16 for the angle. All other registers and words are unknown, and all flags undefined.
State enter(Terms& terms, Routine routine);

/// The results of the routine, 32 bits each, from the state at the end of a path.
std::vector<Term> results(Terms& terms, Routine routine, const State& end);

/// Whether the routine preserves what its caller relies on: SI, DI and BP; SP just past the return
/// address; the operands of a transform; and for FixedMul the caller's stack, which the proofs of
/// its callers rely on.
Term preserves_state(Terms& terms, Routine routine, const State& start, const State& end);

}  // namespace x86model::symbolic
