/// @file
/// The operations and their variants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "verify/cases/build.hpp"
#include "verify/cases/format.hpp"
#include "verify/cases/operation.hpp"

namespace fixproof::cases {

/// One operation under one set of rules, at one width.
struct Variant {
  Operation operation = Operation::mul;
  Build build{};
  /// Of the results, and of the operands unless these have their own. Routines exist in 16.16 and
  /// 8.8.
  Format format = q16_16;
  /// Of the operands, if it is not that of the results.
  std::optional<Format> from{};
  /// Of dot: the number of products, 1 ... max_terms.
  std::size_t terms = 2;

  friend bool operator==(const Variant&, const Variant&) = default;
};

/// Tells whether the operation rounds. Its own switch decides; CosSin never rounds.
constexpr bool rounds(const Variant& v) {
  return v.operation == Operation::div ? v.build.div_round : v.build.mul_round;
}

/// Tells whether the routine has a repaired form: only the 8088 ConcatXforms loses a carry.
constexpr bool can_be_repaired(Operation operation, Target target) {
  return operation == Operation::concat && target == Target::i8088;
}

/// Tells whether the sum in the fourth column loses the carry from the fraction to the whole part.
constexpr bool loses_carry(const Variant& v) {
  return can_be_repaired(v.operation, v.build.target) && !v.build.repaired;
}

/// Returns an operation on operands of one format with results of another. It is no build of
/// FIXED.ASM.
constexpr Variant variant_of(Operation operation, const Format& operands, const Format& results) {
  Variant variant{.operation = operation, .build = {.target = Target::standard}, .format = results};
  if (operands != results) variant.from = operands;
  return variant;
}

constexpr Variant variant_of(Operation operation, const Format& format) {
  return variant_of(operation, format, format);
}

/// Returns a routine of a build at full width. Drops `repaired` if it has no repaired form.
constexpr Variant variant_of(Operation operation, const Build& build) {
  Variant variant{.operation = operation, .build = build};
  variant.build.repaired = build.repaired && can_be_repaired(operation, build.target);
  return variant;
}

/// The format of each operand that is a word.
constexpr Format operand_format(const Variant& v) { return v.from.value_or(v.format); }

/// The number of operands of a case.
constexpr std::size_t operands_of(const Variant& v) {
  return v.operation == Operation::dot ? 2 * v.terms : words_in(v.operation);
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
  return operands_of(v) * static_cast<std::size_t>((operand_bits(v) + 31) / 32);
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
         !is_sum(v.operation) && !v.from && (has_model || !is_function(v.operation)) &&
         (v.format == q16_16 || v.format == q8_8);
}

std::string_view name_of(Target t);
/// A short description: `mul i8088 off`, `sqrt standard`, `div i386 on, chapter 52, 8.8`.
std::string name_of(const Variant& variant);
/// Returns the operation with this command-line name.
/// @throws std::invalid_argument for any other name
Operation operation_named(std::string_view name);
/// Tells whether the format has the operation: functions of real numbers are for units of 2^-F,
/// with 0 <= F <= the bits, and `remainder` is for signed formats.
constexpr bool is_in_format(Operation operation, const Format& format) {
  if (operation == Operation::remainder) return format.is_signed;
  return !is_function(operation) || (!format.is_decimal && format.fraction_bits >= 0 &&
                                     format.fraction_bits <= format.word_bits);
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
