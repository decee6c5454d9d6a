/// @file
/// Where the printed 8088 ConcatXforms differs from the repaired one: see docs/findings.md, 18.
#pragma once

#include <string>
#include <vector>

#include "x86model/assemble.hpp"

namespace fixproof::proof {

/// SMT-LIB scripts. All of them are unsatisfiable if and only if this holds for every operand: the
/// two programs differ in the fourth column alone; there a row differs exactly where the low word
/// of the sum of products and the low word of the translation carry; and the printed result is then
/// 1.0 lower modulo 2^32. One script for each row says that the printed program adds the two in
/// parts and the repaired one as a whole. One script says that the other columns are the same. The
/// last says of any two words where the two sums differ, and by how much. Products are values of an
/// open function, as in questions().
/// @throws std::logic_error for a program that does not return on its only path
std::vector<std::string> lost_carry_questions(const x86model::Program& printed,
                                              const x86model::Program& repaired);

}  // namespace fixproof::proof
