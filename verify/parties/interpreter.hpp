/// @file
/// The party that interprets programs step by step: the listings, or programs that replace them.
#pragma once

#include <memory>
#include <string>

#include "verify/parties/party.hpp"
#include "x86model/routine.hpp"

namespace fixproof::parties {

/// Returns the program of a variant of FIXED.ASM.
/// @throws std::invalid_argument for any other variant
x86model::Program program_of(const cases::Variant& variant);

/// Makes a party that runs `program` instead of the routine of every variant. A case is broken if
/// the program does not preserve SI, DI, BP and SP, or if a transform changes its operands.
std::unique_ptr<Party> make_interpreter_of(std::string name, const x86model::Program& program);

}  // namespace fixproof::parties
