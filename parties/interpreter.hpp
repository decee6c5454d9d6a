/// @file
/// Programs interpreted step by step: the listings', or any other that takes a routine's place.
#pragma once

#include <memory>
#include <string>

#include "parties/party.hpp"
#include "x86model/routine.hpp"

namespace fixproof::parties {

/// The program of a variant of FIXED.ASM. @throws std::invalid_argument for any other variant
x86model::Program program_of(const cases::Variant& variant);

/// A party that runs `program` in the place of the routine of every variant it is asked. A program
/// that does not keep SI, DI, BP and SP as C wants them kept, or a transform its operands, breaks
/// down.
std::unique_ptr<Party> make_interpreter_of(std::string name, const x86model::Program& program);

}  // namespace fixproof::parties
