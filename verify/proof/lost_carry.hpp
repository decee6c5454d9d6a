/// @file
/// Where the printed 8088 ConcatXforms differs from the repaired one: see docs/findings.md, 18.
#pragma once

#include <string>
#include <vector>

#include "x86model/assemble.hpp"

namespace fixproof {

/// SMT-LIB scripts. All are unsatisfiable exactly where, for every operand, the two programs give
/// the same words but for the fourth column, and there, in row i, different ones exactly where the
/// low word of the sum of products and the low word of the translation carry: the printed result is
/// then 1.0 lower modulo 2^32. A script for each row says that the printed program adds the two in
/// parts and the repaired one as a whole; one says that all else is the same; and the last, which
/// is about any two words, where these two sums differ, and by what. Products are values of an open
/// function, as in questions().
/// @throws std::logic_error for a program that does not return on its only path
std::vector<std::string> lost_carry_questions(const x86model::Program& printed,
                                              const x86model::Program& repaired);

}  // namespace fixproof
