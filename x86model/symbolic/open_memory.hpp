/// @file
/// Memory with unconstrained contents; see RunOptions::memory_is_open.
#pragma once

#include <optional>

#include "x86model/instruction.hpp"
#include "x86model/symbolic/state.hpp"

namespace x86model::symbolic::open_memory {

/// The value of a memory operand; nothing once the data segment has been written.
std::optional<Term> read(Terms& terms, const State& state, const Operand& operand, Size size);

/// Records a write to a memory operand.
void write(Terms& terms, State& state, const Operand& operand, Term value);

/// STOSB and STOSW, by size.
void store_string(Terms& terms, State& state, Size size);

}  // namespace x86model::symbolic::open_memory
