/// @file
/// The questions to a solver about one turn of an inner loop.
#pragma once

#include <string>
#include <vector>

#include "x86model/loop.hpp"

namespace fixproof::proof {

/// Returns SMT-LIB scripts. If all of them are unsatisfiable, one turn of the loop, from its first
/// instruction back to it or out of it, meets the specification for every value of the registers
/// and of memory: the registers, the stores and their addresses, the condition for another turn,
/// and no read of an undefined flag. The last script states that the paths cover all register
/// values. The scripts assume that STOS writes to a different segment from the one that holds the
/// operands.
/// @param program assembled from the listing of the form, or a broken one
std::vector<std::string> step_questions(const x86model::LoopForm& form,
                                        const x86model::Program& program);

/// Returns a script that is unsatisfiable if and only if the depth test compares bits 23 to 8 of
/// the depth, as the comment in its source says.
/// @param form of the depth test
std::string depth_comment_question(const x86model::LoopForm& form);

}  // namespace fixproof::proof
