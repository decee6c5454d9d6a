#pragma once

#include <cstdint>
#include <stdexcept>

/// The words, formats and rules of the oracle's interface.
namespace oracle {

/// A word of at most 32 bits; see LongWord.
using Word = std::uint32_t;

/// A fixed-point operand or result of a format as bits, zero-extended. Bits of an operand above the
/// format's are ignored; those of a result are 0.
using LongWord = std::uint64_t;

/// A word with raw integer n has the value n ulps. The unit in the last place (ulp) is
/// 2^-fraction_bits.
struct Format {
  constexpr Format(int word_bits, int fraction, bool has_sign)
      : bits(word_bits), fraction_bits(fraction), is_signed(has_sign) {}
  /// The format of FIXED.ASM's words with F fraction bits, 2 ... 16: 2F bits, signed.
  /// @throws std::invalid_argument for any other number
  constexpr Format(int fraction = 16)  // NOLINT(*-explicit-*): F alone names one of them
      : bits(2 * in_routines(fraction)), fraction_bits(fraction), is_signed(true) {}

  int bits;           ///< 1 ... 64
  int fraction_bits;  ///< 0 ... bits
  bool is_signed;     ///< two's complement; otherwise unsigned

 private:
  static constexpr int in_routines(int fraction) {
    if (fraction >= 2 && fraction <= 16) return fraction;
    throw std::invalid_argument("fraction_bits must be 2 ... 16");
  }
};

/// How an exact rational is rounded to an integer number of ulps.
enum class Rounding {
  half_up,    ///< to nearest, ties toward +infinity
  half_away,  ///< to nearest, ties away from zero
  floor,      ///< toward -infinity
  truncate,   ///< toward zero
  half_even,  ///< to nearest, ties to even
  ceiling,    ///< toward +infinity
};

/// The result of n / d by a divide of FIXED.ASM, and when it raises #DE.
enum class DivideRule {
  /// To nearest, ties away from zero. #DE if |n/d|, truncated to ulps, is 2^2F or more, or d = 0.
  /// Quotients that exceed only the signed range wrap without a fault.
  i386_rounded,
  /// Toward zero. #DE if the result is outside the signed range of 2F bits, or d = 0.
  i386_unrounded,
  /// The magnitude of d is truncated to a whole number first; then to nearest, ties away from zero,
  /// wrapped. #DE if and only if |d| < 1.0.
  i8088_rounded,
  /// As i8088_rounded, but toward zero.
  i8088_unrounded,
};

/// How a product of transforms adds the first transform's translation.
enum class TranslationRule {
  fourth,  ///< only in the fourth column, as in matrix algebra
  every,   ///< in all four columns, as in listing 52.4
  /// Only in the fourth column. Fractions are added to fractions and whole parts to whole parts, as
  /// in the 8088 listing. Let x and t be the sum of products and the translation, and frac(x) = x -
  /// floor(x): the result is floor(x) + floor(t) + frac(x + t). This is x + t - 1 if frac(x) +
  /// frac(t) is 1 or more.
  fourth_in_parts,
};

/// A cosine and a sine in 16.16.
struct CosSin {
  Word cos;
  Word sin;
  friend bool operator==(const CosSin&, const CosSin&) = default;
};

}  // namespace oracle
