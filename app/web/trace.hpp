/// @file
/// Runs of the routines of FIXED.ASM and of the inner loops, with every state recorded, so that a
/// person can step backward.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::web {

/// Returns the routines and the names of their builds.
/// @return JSON
std::string routines();

/// Records one or two builds of a routine on the same operands.
/// @param request four lines: routine, first build, second build or `none`, and operands; then, to
/// change the first build, its registers on entry, and lines of code that edit_of() reads. The
/// operands are what operand_of() reads in 16.16, separated by spaces or commas. The operand of
/// cossin is a whole number of tenths of a degree. Those of an inner loop are the number of pixels,
/// its value and its step, for a texture also a row and its step; all but the first are read
/// in 24.8.
/// @return JSON: listings, results, and the first step at which the builds differ; `error` says
/// what is wrong with the request
std::string trace(std::string_view request);

/// Returns the state of the machine after a number of instructions of a recorded run.
/// @param request two lines: the run, 0 or 1, and the number of instructions. A number that is
/// larger than the run's means its end.
/// @return JSON
std::string state(std::string_view request);

}  // namespace fixproof::web
