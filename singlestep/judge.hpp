/// @file
/// The model against one case.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "singlestep/decode.hpp"
#include "singlestep/read.hpp"

namespace fixproof::singlestep {

/// What differs, each as `ax: model 0001, file 0002`; nothing where model and case are equal.
using Differences = std::vector<std::string>;

/// Executes the case's instruction in the model and compares what it leaves with the case: a divide
/// error or none, all registers but the instruction pointer, all flags but those that Intel leaves
/// undefined.
///
/// A case faults where its CS:IP is that of interrupt vector 0, SP is 6 lower and what is listed of
/// the stack is the return address: that of the next instruction on the 8088, of the divide itself
/// on the 386. Flags after a fault are not judged, neither those pushed nor those in the register.
///
/// @throws UsageError where the bytes are not one instruction
std::variant<Differences, Skip> judge(const Case& c, x86model::Target cpu);

}  // namespace fixproof::singlestep
