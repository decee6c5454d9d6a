/// @file
/// Proves where the printed 8088 ConcatXforms differs from the repaired one: docs/findings.md, 18.
#pragma once

#include <string>
#include <vector>

#include "x86model/assemble.hpp"

namespace fixproof::proof {

/// Returns SMT-LIB scripts. All of them are unsatisfiable if and only if three statements hold for
/// every operand: the two programs differ only in the fourth column; a row differs there if and
/// only if adding the low words of the dot product and of the translation produces a carry; and the
/// printed result is then 1.0 lower modulo 2^32.
/// One script per row states that the printed program adds the two in parts and the repaired one as
/// a whole. One script states that the other columns are equal. The last states for any two words
/// when and by how much the two sums differ. Products are values of an uninterpreted function, as
/// in questions().
/// @throws std::logic_error if a program has several paths or does not return
std::vector<std::string> lost_carry_questions(bool mul_round);

/// The same for any two programs in place of the printed and the repaired one.
std::vector<std::string> lost_carry_between(const x86model::Program& printed,
                                            const x86model::Program& repaired);

}  // namespace fixproof::proof
