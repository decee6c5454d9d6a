/// @file
/// The operations and their variants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "verify/cases/build.hpp"
#include "verify/cases/format.hpp"

namespace fixproof::cases {

/// The FIXED.ASM routines, then the operations that only the type has.
enum class Operation : std::uint8_t {
  mul,
  div,
  cossin,
  xformvec,
  concat,
  sqrt,      ///< square root; 0 for a negative operand
  sin,       ///< sine of an angle in radians
  cos,       ///< cosine of an angle in radians
  decimal,   ///< conversion to decimal text and back: the identity
  binary64,  ///< conversion to double and back: the identity
  add,       ///< a + b, for `gen`, `eval` and `check`
  sub,       ///< a - b, likewise
  // Functions of words of at most 32 bits, to nearest; out of range they saturate. More follow
  // below, because the streams of cases depend on the place here.
  exp2,   ///< 2 to the power of the operand
  exp,    ///< e to the power of the operand
  log2,   ///< binary logarithm; the lowest word unless the operand is positive
  log,    ///< natural logarithm, likewise
  log10,  ///< decimal logarithm, likewise
  // Conversions, for `gen` and `check`.
  from_binary64,  ///< a double to a word
  convert,        ///< a word of another format to a word
  from_decimal,   ///< decimal text to a word
  to_decimal,     ///< a word to decimal text
  // More functions. Outside its domain a logarithm is the lowest word; a root, a reciprocal, a
  // tangent or a power of 0 is the highest; and any other function is 0.
  expm1,  ///< exp(x) - 1
  log1p,  ///< log(1 + x)
  sinh,
  cosh,
  tanh,
  tan,
  sin_of_degrees,
  cos_of_degrees,
  tan_of_degrees,
  sin_of_turns,
  cos_of_turns,
  tan_of_turns,
  asin,
  acos,
  atan,
  cbrt,
  rsqrt,       ///< 1 / sqrt(x)
  reciprocal,  ///< 1 / x
  atan2,       ///< the angle of the vector (second operand, first operand)
  hypot,       ///< the length of a vector
  pow,         ///< the first operand to the power of the second
  // Functions of a quotient; a zero divisor is a divide error.
  fmod,       ///< the remainder of the quotient truncated toward zero, exact
  remainder,  ///< the remainder of the nearest whole quotient, ties to even; exact, signed formats
  mul_div,    ///< a * b / c, rounded once
  // One more function of real numbers.
  hypot3,  ///< the length of a vector of three numbers
};

/// One operation under one set of rules, at one width.
struct Variant {
  Operation operation = Operation::mul;
  Build build{};
  /// Of the operands and results. Routines exist in 16.16 and 8.8.
  Format format = q16_16;
  /// Of the operand of `convert`, whose result has the other format.
  Format from = q16_16;

  friend bool operator==(const Variant&, const Variant&) = default;
};

/// Tells whether the operation rounds. Its own switch decides; CosSin never rounds.
constexpr bool rounds(const Variant& v) {
  return v.operation == Operation::div ? v.build.div_round : v.build.mul_round;
}

constexpr std::size_t words_in(Operation o) {
  switch (o) {
    case Operation::mul:
    case Operation::div:
    case Operation::add:
    case Operation::sub:
    case Operation::atan2:
    case Operation::hypot:
    case Operation::pow:
    case Operation::fmod:
    case Operation::remainder:
      return 2;
    case Operation::mul_div:
    case Operation::hypot3:
      return 3;
    case Operation::xformvec:
      return 15;
    case Operation::concat:
      return 24;
    default:
      return 1;
  }
}
constexpr std::size_t words_out(Operation o) {
  switch (o) {
    case Operation::cossin:
      return 2;
    case Operation::xformvec:
      return 3;
    case Operation::concat:
      return 12;
    default:
      return 1;
  }
}
inline constexpr std::size_t max_words_in = 24;
inline constexpr std::size_t max_words_out = 12;

/// Tells whether the routine has a repaired form: only the 8088 ConcatXforms loses a carry.
constexpr bool can_be_repaired(Operation operation, Target target) {
  return operation == Operation::concat && target == Target::i8088;
}

/// Tells whether the sum in the fourth column loses the carry from the fraction to the whole part.
constexpr bool loses_carry(const Variant& v) {
  return can_be_repaired(v.operation, v.build.target) && !v.build.repaired;
}

/// Returns a routine of a build at full width. Drops `repaired` if it has no repaired form.
constexpr Variant variant_of(Operation operation, const Build& build) {
  Variant variant{.operation = operation, .build = build};
  variant.build.repaired = build.repaired && can_be_repaired(operation, build.target);
  return variant;
}

constexpr bool is_conversion(Operation o) {
  return o >= Operation::from_binary64 && o <= Operation::to_decimal;
}

/// Tells whether the operation is a function of real numbers. sin and cos of radians are functions
/// in the formats that has_routine_format() does not cover.
constexpr bool is_function(Operation o) {
  return (o >= Operation::exp2 && o <= Operation::log10) ||
         (o >= Operation::expm1 && o <= Operation::pow) || o == Operation::hypot3 ||
         o == Operation::sin || o == Operation::cos;
}

/// Tells whether the operation is a function of a quotient: a remainder, or the quotient of a
/// product. These exist in every format, but `remainder` only in signed ones.
constexpr bool is_quotient_function(Operation o) {
  return o >= Operation::fmod && o <= Operation::mul_div;
}

/// Tells whether a zero divisor leaves the operation without a result.
constexpr bool divides(Operation o) { return o == Operation::div || is_quotient_function(o); }

/// The format of each operand that is a word.
constexpr const Format& operand_format(const Variant& v) {
  return v.operation == Operation::convert ? v.from : v.format;
}

/// The width of each operand. The angle of cossin has half the bits of a word. A case of
/// from_decimal has 96 bits, which append_decimal_operand() turns into text.
constexpr int operand_bits(const Variant& v) {
  switch (v.operation) {
    case Operation::cossin:
      return v.format.word_bits / 2;
    case Operation::from_binary64:
      return 64;
    case Operation::from_decimal:
      return 96;
    default:
      return operand_format(v).word_bits;
  }
}

/// Cases and answers are stored in words of 32 bits. A number of 64 bits takes two, the low half
/// first.
constexpr std::size_t words_per_number(const Format& format) {
  return format.word_bits > 32 ? 2 : 1;
}
constexpr std::size_t words_in(const Variant& v) {
  return words_in(v.operation) * static_cast<std::size_t>((operand_bits(v) + 31) / 32);
}
constexpr std::size_t words_out(const Variant& v) {
  return words_out(v.operation) * words_per_number(v.format);
}
/// The bits of each stored word of an operand.
constexpr int stored_bits(const Variant& v) { return operand_bits(v) > 32 ? 32 : operand_bits(v); }

/// Tells whether the variant has one of the formats of FIXED.ASM's routines and their models.
/// Conversions and all functions are the same in every format, but for sin and cos.
constexpr bool has_routine_format(const Variant& v) {
  const bool has_model = v.operation == Operation::sin || v.operation == Operation::cos;
  return !is_conversion(v.operation) && !is_quotient_function(v.operation) &&
         (has_model || !is_function(v.operation)) && (v.format == q16_16 || v.format == q8_8);
}

constexpr bool is_routine(Operation o) { return o <= Operation::concat; }

std::string_view name_of(Operation o);
std::string_view name_of(Target t);
/// A short description: `mul i8088 off`, `sqrt standard`, `div i386 on, chapter 52, 8.8`.
std::string name_of(const Variant& variant);
/// Returns the operation with this command-line name.
/// @throws std::invalid_argument for any other name
Operation operation_named(std::string_view name);
/// Tells whether the format has the operation: functions of real numbers are for at most 32 bits,
/// and `remainder` is for signed formats.
constexpr bool is_in_format(Operation operation, const Format& format) {
  if (operation == Operation::remainder) return format.is_signed;
  return !is_function(operation) || format.word_bits <= 32;
}
/// @throws UsageError unless is_in_format()
void check_format(Operation operation, const Format& format);
/// All functions, separated by commas: `sin, cos, exp2, ...`.
std::string function_names();
/// Like operation_named(), but only for the routines of FIXED.ASM.
Operation routine_named(std::string_view name);

/// Returns every 16.16 variant that a verification compares, in the order of the table: each
/// routine on both processors with and without rounding, the forms of chapter 52, the repaired 8088
/// ConcatXforms, and the operations under the type's standard rules.
std::vector<Variant> all_variants();

}  // namespace fixproof::cases
