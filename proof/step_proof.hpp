/// @file
/// What a solver is asked of one turn of an inner loop.
#pragma once

#include <string>
#include <vector>

#include "x86model/loop.hpp"

namespace fixproof::proof {

/// SMT-LIB scripts. Where all of them are unsatisfiable, one turn of the loop, from its first
/// instruction back to it or out of it, does what the specification says for every value of the
/// registers and of memory: the registers, what is stored and where, when it goes on, and that no
/// undefined flag is read. The last says that there are no registers but those of the paths. STOS
/// is taken to write another segment than the operands are read from.
/// @param program assembled from the listing of the form, or a broken one
std::vector<std::string> step_questions(const x86model::LoopForm& form,
                                        const x86model::Program& program);

/// The script that is unsatisfiable exactly where what the depth test compares is what the comment
/// of its source says: bits 23 to 8 of the depth.
/// @param form of the depth test
std::string depth_comment_question(const x86model::LoopForm& form);

}  // namespace fixproof::proof
