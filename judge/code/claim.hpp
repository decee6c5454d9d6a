/// @file
/// States in SMT-LIB what a routine should return. It follows the rules, not any program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/check/rules.hpp"

namespace fixproof::judge {

/// How the exact result is composed of products and quotients of machine words. All shapes describe
/// the same result, but a proof under abstract arithmetic needs the shape that the routine uses.
enum class Shape {
  of_signed,      ///< IMUL and IDIV of the operands
  of_magnitudes,  ///< MUL and DIV of their magnitudes, then the sign
  of_digits,      ///< MUL of the 16-bit halves of their magnitudes (proof's lemma product-of-words)
};
inline constexpr std::initializer_list<Shape> shapes{Shape::of_signed, Shape::of_magnitudes,
                                                     Shape::of_digits};

struct Claim {
  std::string definitions{};
  std::string may_fault{};         ///< a Boolean: whether #DE is right
  std::string may_trap = "false";  ///< a Boolean: whether UD2 is right
  /// A Boolean: whether the word that replaces {} is right.
  std::string is_right{};
  /// Conditions that together hold for all operands. The solver is asked about one after the other,
  /// because that takes less time than all at once.
  std::vector<std::string> cases{"true"};
};

/// Returns the claim for operands a, b and c. Returns nothing if the operation is not mul, div,
/// mul_div, add or sub, if the format is unsigned or does not have 16 or 32 bits, if the rules need
/// more than the machine's divide tells, or if a program's rule differs from the general rules in
/// more than Doom's guard.
std::optional<Claim> claim_of(const check::Rules& rules, Shape shape);

}  // namespace fixproof::judge
