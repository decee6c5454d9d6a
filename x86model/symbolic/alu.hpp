/// @file
/// Results and flags of the arithmetic instructions as terms: the definitions of x86model/alu.hpp
/// for all operands at once. Models only the flags that some routine reads.
#pragma once

#include <optional>

#include "x86model/instruction.hpp"
#include "x86model/symbolic/term.hpp"

namespace x86model::symbolic {

/// A flag as a truth value; empty if Intel leaves it undefined.
using FlagTerm = std::optional<Term>;

/// The flags that routines read: not PF and AF.
struct FlagTerms {
  FlagTerm carry, zero, sign, overflow;
};

struct Result {
  Term value;
  FlagTerms flags;
};

/// a + b + carry and a - b - borrow.
Result add(Terms& terms, Term a, Term b, Term carry);
Result sub(Terms& terms, Term a, Term b, Term borrow);
/// high:low as one term. If the words come from ADD and ADC, or from NEG, NEG and SBB, it is the
/// sum or the negation of the joined operands.
Term join(Terms& terms, Term high, Term low);
/// The flags of AND and XOR.
Result logic(Terms& terms, Term value);
/// SHL, SHR, SAR and ROL by 0 < count < 32.
Result shift(Terms& terms, Mnemonic op, Term a, int count);
/// SHLD and SHRD, 0 < count < width.
Result double_shift(Terms& terms, Mnemonic op, Term a, Term fill, int count);

/// MUL and IMUL: twice as wide as the operands. The product is an application of `umulN` or
/// `smulN`.
Result multiply(Terms& terms, Mnemonic op, Term a, Term b);

/// DIV and IDIV of a dividend twice as wide as the divisor: applications of `udivN` and `uremN`, or
/// `sdivN` and `sremN`.
struct Division {
  Term quotient;
  Term remainder;
  /// #DE. For IDIV an application of `sfaultN`; for DIV the exact condition: the dividend's upper
  /// half is not below the divisor.
  Term faults;
};
Division divide(Terms& terms, Mnemonic op, Term dividend, Term divisor);

/// Whether a jump is taken; empty if it reads an undefined flag. Unconditional jumps are always
/// taken.
std::optional<Term> taken(Terms& t, Mnemonic op, const FlagTerms& f);

}  // namespace x86model::symbolic
