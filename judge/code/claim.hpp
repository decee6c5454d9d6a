/// @file
/// States in SMT-LIB what a routine should return. It follows the rules, not any program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/check/rules.hpp"
#include "x86model/symbolic/term.hpp"

namespace fixproof::judge {

/// How the exact result is composed of products and quotients of machine words. All shapes describe
/// the same result, but a proof under abstract arithmetic needs the shape that the routine uses.
enum class Shape {
  of_signed,      ///< IMUL and IDIV of the operands
  of_magnitudes,  ///< MUL and DIV of their magnitudes, then the sign
  of_digits,      ///< MUL of the 16-bit halves of their magnitudes (proof's lemma product-of-words)
  of_extended,    ///< IMUL of the operands extended to 32 bits
};
inline constexpr std::initializer_list<Shape> shapes{Shape::of_signed, Shape::of_magnitudes,
                                                     Shape::of_digits, Shape::of_extended};

struct Claim {
  std::string definitions{};
  std::string may_fault{};         ///< a Boolean: whether #DE is right
  std::string may_trap = "false";  ///< a Boolean: whether UD2 is right
  /// A Boolean: whether the word that replaces {} is right.
  std::string is_right{};
  /// Conditions that together hold for all operands. The solver is asked about one after the other,
  /// because that takes less time than all at once.
  std::vector<std::string> cases{"true"};
  std::vector<x86model::symbolic::Term> mentions{};  ///< terms whose names the definitions use
};

/// An exact result: a signed number in units of a word's times 2^-`excess`.
struct Exact {
  std::string definitions{};  ///< of `exact` and, unless `excess` is 0, its magnitude `exact-size`
  int bits = 0;               ///< of both; they hold one more unit of a word
  int excess = 0;             ///< 0 to 64
};

/// The bits of `product`: a signed number with room for one more unit of a word.
int product_bits(const cases::Format& format);
/// Defines `product`, that of a and b, and `product-size`, its magnitude.
/// @pre the shape suits the words: see has_product()
std::string define_product(const cases::Format& format, Shape shape);
/// Tells whether words of 8 to 64 bits have a product of that shape.
bool has_product(const cases::Format& format, Shape shape);

/// The product of a and b. @pre has_product()
Exact exact_product(const cases::Format& format, Shape shape);
/// The sum or difference of a and b. @param operation bvadd or bvsub
Exact exact_sum(const cases::Format& format, const char* operation);

/// States that a routine rounds an exact result as the rules say. Also defines `cut`, the rounded
/// result modulo the range, and `fits`, whether it is in range; `lacks` is false and `found` true,
/// as quotient_claim() has them.
Claim rounded_claim(const Exact& exact, const check::Rules& rules);

/// Returns the claim for operands a, b and c. Returns nothing if the operation is not mul, div,
/// mul_div, add or sub, if the format is not one of the type's or its words have no such product,
/// if the rules need more than the machine's divide tells, or if a program's rule differs from the
/// general rules in more than Doom's guard.
std::optional<Claim> claim_of(const check::Rules& rules, Shape shape);

}  // namespace fixproof::judge
