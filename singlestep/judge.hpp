/// @file
/// Compares the model with one captured case.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "singlestep/decode.hpp"
#include "singlestep/read.hpp"

namespace fixproof::singlestep {

/// One entry per difference, such as `ax: model 0001, file 0002`; empty if model and case agree.
using Differences = std::vector<std::string>;

/// Executes the case's instruction in the model and compares the results: whether a divide error
/// occurs, all registers except the instruction pointer, and all flags except those that Intel
/// leaves undefined.
///
/// A case faults if its CS:IP is that of interrupt vector 0, SP is 6 lower and the listed stack
/// bytes match the return address. That is the address of the next instruction on the 8088 and of
/// the divide itself on the 386. Flags after a fault are not compared, neither the pushed ones nor
/// the register.
///
/// @throws UsageError if the bytes are not exactly one instruction
std::variant<Differences, Skip> judge(const Case& c, x86model::Target cpu);

}  // namespace fixproof::singlestep
