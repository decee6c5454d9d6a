#pragma once

#include <cstdint>

/// The words and rules in which every question to the oracle is put.
namespace oracle {

/// A fixed-point operand or result as bits: 2F-bit two's complement, zero-extended, where F is the
/// number of fraction bits, 2 ... 16. The unit of the last place (ulp) is 2^-F. Bits above the low
/// 2F of an operand are ignored; those of a result are 0.
using Word = std::uint32_t;

/// How an exact rational becomes an integer number of ulps.
enum class Rounding {
  half_up,    ///< nearest, halves toward +infinity
  half_away,  ///< nearest, halves away from zero
  floor,      ///< toward -infinity
  truncate,   ///< toward zero
  half_even,  ///< nearest, halves to the even neighbour
};

/// What a divide of FIXED.ASM returns and when it raises #DE, for n / d.
enum class DivideRule {
  /// Nearest, halves away from zero. #DE when |n/d|, truncated to ulps, is 2^2F or more, or d = 0;
  /// quotients that only the sign bit cannot hold wrap without a fault.
  i386_rounded,
  /// Toward zero. #DE when the result is outside the signed range of 2F bits, or d = 0.
  i386_unrounded,
  /// The magnitude of d loses its fraction first; then nearest, halves away from zero, wrapped.
  /// #DE exactly when |d| < 1.0.
  i8088_rounded,
  /// As i8088_rounded, but toward zero.
  i8088_unrounded,
};

/// How a product of transforms receives the first transform's translation.
enum class TranslationRule {
  fourth,  ///< in the fourth column alone, as matrix algebra has it
  every,   ///< in all four columns, as listing 52.4 has it
  /// In the fourth column alone. Fractions are added to fractions and whole parts to whole parts,
  /// as in the 8088 listing. Let x and t be the sum of products and the translation, and frac(x) =
  /// x - floor(x): the result is floor(x) + floor(t) + frac(x + t). It is x + t less 1 where
  /// frac(x) + frac(t) is 1 or more.
  fourth_in_parts,
};

/// A cosine and a sine in 16.16.
struct CosSin {
  Word cos;
  Word sin;
  friend bool operator==(const CosSin&, const CosSin&) = default;
};

}  // namespace oracle
