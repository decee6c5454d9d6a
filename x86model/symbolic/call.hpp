/// @file
/// A call of a routine with operands left open, laid out as x86model/call.hpp lays out one.
#pragma once

#include <string>
#include <vector>

#include "x86model/routine.hpp"
#include "x86model/symbolic/run.hpp"

namespace x86model::symbolic {

/// What operand `index` of a routine is called: a and b; angle; x0 ... x11, v0 ... v2 for XformVec;
/// p0 ... p11, q0 ... q11 for ConcatXforms.
std::string operand_name(Routine routine, int index);

/// The machine at the routine's first instruction: operands as variables of those names, 32 bits
/// each but for the angle's 16, all other registers and words unknown, all flags undefined.
State enter(Terms& terms, Routine routine);

/// What the routine has returned, 32 bits each, from the state at the end of a path.
std::vector<Term> results(Terms& terms, Routine routine, const State& end);

/// What the routine must leave as it was: SI, DI and BP; SP just past the return address; the
/// operands of a transform; and for FixedMul, whose callers are proven on the strength of it, the
/// caller's stack.
Term keeps_what_it_must(Terms& terms, Routine routine, const State& start, const State& end);

}  // namespace x86model::symbolic
