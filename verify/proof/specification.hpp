/// @file
/// The specification of each routine in SMT-LIB, written from docs/semantics.md and not from any
/// program.
#pragma once

#include <string>
#include <vector>

#include "verify/cases/variant.hpp"

namespace fixproof::proof {

/// Whether products and quotients are uninterpreted or exactly defined. Uninterpreted, a solver
/// proves in seconds what holds for any arithmetic, but a counterexample may be spurious.
enum class Arithmetic { abstract, exact };

/// Returns declarations of the abstract functions and definitions based on them:
///   umulN   the product of two unsigned N-bit words; smulN for signed words, from umulN
///   udivN, uremN, sdivN, sremN   quotient and remainder of a dividend of 2N bits
///   sfaultN   whether a signed quotient does not exist or does not fit
///   fixedmul  the product of two 16.16 words, as FixedMul returns it
///   cosword   a word of the cosine table, by its offset in bytes
std::string abstractions(Arithmetic arithmetic);

/// The answer for the operands that x86model/symbolic/call.hpp names.
struct Specification {
  std::string definitions;
  std::string faults;              ///< a Boolean: whether #DE occurs
  std::vector<std::string> words;  ///< 32 bits each
  /// The digit products of a routine that multiplies digit by digit, in the order of the listing.
  /// Proving them equal first simplifies the rest of the proof.
  std::vector<std::string> products{};
};

/// Defines sum-in-parts, which adds the fractions and the whole parts of two words separately,
/// without a carry between them.
inline constexpr const char* sum_in_parts =
    R"((define-fun sum-in-parts ((x (_ BitVec 32)) (y (_ BitVec 32))) (_ BitVec 32)
  (concat (bvadd ((_ extract 31 16) x) ((_ extract 31 16) y))
          (bvadd ((_ extract 15 0) x) ((_ extract 15 0) y))))
)";

/// Returns the specification of a routine under the rules of FIXED.ASM, at full width.
Specification specification(const cases::Variant& variant);

}  // namespace fixproof::proof
