/// @file
/// What each routine is to return, in SMT-LIB: written from the statements of docs/semantics.md,
/// not from any program.
#pragma once

#include <string>
#include <vector>

#include "cases/variant.hpp"

namespace fixproof::proof {

/// What a solver is told of products and quotients: nothing, or what they are. Told nothing, it
/// proves in seconds what holds whatever they are; a counterexample may then owe to it.
enum class Arithmetic { abstract, exact };

/// Declarations of what stays abstract, and definitions of what follows from it:
///   umulN   the product of two unsigned N-bit words; smulN of two signed ones, from umulN
///   udivN, uremN, sdivN, sremN   quotient and remainder of a dividend of 2N bits
///   sfaultN   whether a signed quotient does not exist or does not fit
///   fixedmul  the product of two 16.16 words, as FixedMul returns it
///   cosword   a word of the cosine table, by its offset in bytes
std::string abstractions(Arithmetic arithmetic);

/// The answer of a variant for the operands that x86model/symbolic/call.hpp names.
struct Specification {
  std::string definitions;
  std::string faults;              ///< of #DE, a truth value
  std::vector<std::string> words;  ///< 32 bits each
  /// Where a routine multiplies digit by digit: the products, in the order of the listing. Shown to
  /// be its own first, they make the rest easy.
  std::vector<std::string> products{};
};

/// The specification of one of the routines under FIXED.ASM's rules, at full width.
Specification specification(const cases::Variant& variant);

}  // namespace fixproof::proof
