/// @file
/// Recorded runs of the routines of FIXED.ASM: every state, so that a person can step backward.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::web {

/// The routines and, for each, the names of its builds.
/// @return JSON
std::string routines();

/// Records one or two builds of a routine on the same operands.
/// @param request routine, first build, second build or `none`, operands; on four lines. Operands
/// are as operand_of() takes them in 16.16, separated by spaces or commas; that of cossin is a
/// count of tenths of a degree.
/// @return JSON: listings, results, and the first step at which the builds differ; `error` says
/// what is wrong
std::string trace(std::string_view request);

/// The machine after a number of instructions of a recorded run.
/// @param request the run, 0 or 1, and the number, on two lines; a number beyond the end is the end
/// @return JSON
std::string state(std::string_view request);

}  // namespace fixproof::web
