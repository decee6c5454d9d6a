/// @file
/// What a routine should return, in SMT-LIB, written from the rules and not from any program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "check/rules.hpp"

namespace fixproof::judge {

/// How the exact result is put together from products and quotients of machine words. A proof under
/// abstract arithmetic needs the shape that the routine has; each is true.
enum class Shape {
  of_signed,      ///< IMUL and IDIV of the operands
  of_magnitudes,  ///< MUL and DIV of their magnitudes, then the sign
  of_digits,      ///< MUL of the 16-bit halves of their magnitudes (proof's lemma product-of-words)
};
inline constexpr std::initializer_list<Shape> shapes{Shape::of_signed, Shape::of_magnitudes,
                                                     Shape::of_digits};

struct Claim {
  std::string definitions{};
  std::string may_fault{};  ///< a Boolean: #DE is right
  /// A Boolean: the word that replaces {} is right.
  std::string is_right{};
};

/// Returns the claim for operands a, b and c. Empty if there is none: for operations other than
/// mul, div, mul_div, add and sub, unsigned formats, other words than 16 and 32 bits, and rules of
/// programs that differ from the general ones in more than a guard.
std::optional<Claim> claim_of(const check::Rules& rules, Shape shape);

}  // namespace fixproof::judge
