/// @file
/// What is asked: an operation in one of its variants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fixproof::cases {

/// The FIXED.ASM routines, then the operations that only the type has.
enum class Operation : std::uint8_t {
  mul,
  div,
  cossin,
  xformvec,
  concat,
  sqrt,      ///< square root; a negative operand gives 0
  sin,       ///< sine of an angle in radians
  cos,       ///< cosine of an angle in radians
  decimal,   ///< to decimal text and back: the identity
  binary64,  ///< to double and back: the identity
};

/// Whose rules apply.
enum class Target : std::uint8_t {
  i386,
  i8088,
  standard,  ///< the rules of fixed::q16_16: nearest, halves up, wrapping; only a zero divisor
             ///< faults
};

/// One operation under one set of rules. `mul_round` and `div_round` say what the code does.
struct Variant {
  Operation operation = Operation::mul;
  Target target = Target::i386;
  bool mul_round = true;
  bool div_round = true;
  /// The routine as chapter 52 has it (386, rounded): see ConcatXforms.
  bool chapter_52 = false;
  /// The 8088 ConcatXforms with the carry that its listing loses: see docs/findings.md, 18.
  bool repaired = false;
  /// 16 for 16.16 words, 8 for 8.8 words.
  int fraction_bits = 16;

  friend bool operator==(const Variant&, const Variant&) = default;
};

/// Whether the code rounds: the switch that matters to the operation. CosSin has none.
constexpr bool rounds(const Variant& v) {
  return v.operation == Operation::div ? v.div_round : v.mul_round;
}

/// Words a case of the operation takes and gives.
constexpr std::size_t words_in(Operation o) {
  switch (o) {
    case Operation::mul:
    case Operation::div:
      return 2;
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
inline constexpr std::size_t most_words_in = 24;
inline constexpr std::size_t most_words_out = 12;

/// Whether the sum in the fourth column loses the carry from the fraction to the whole part.
constexpr bool loses_carry(const Variant& v) {
  return v.operation == Operation::concat && v.target == Target::i8088 && !v.repaired;
}

/// Bits of each operand: the angle of cossin has half as many as a word.
constexpr int operand_bits(const Variant& v) {
  return v.operation == Operation::cossin ? v.fraction_bits : 2 * v.fraction_bits;
}

/// Whether FIXED.ASM has it.
constexpr bool is_routine(Operation o) { return o <= Operation::concat; }

std::string_view name_of(Operation o);
std::string_view name_of(Target t);
/// A variant in a few words: `mul i8088 off`, `sqrt standard`, `div i386 on, chapter 52, 8.8`.
std::string name_of(const Variant& variant);
/// The name on the command line; throws std::invalid_argument for any other.
Operation operation_named(std::string_view name);
/// As operation_named(), of the routines alone.
Operation routine_named(std::string_view name);

/// Every variant of 16.16, in the order of the verification table: each routine on both processors
/// under both roundings, the forms of chapter 52, the repaired 8088 ConcatXforms, then the
/// operations under the type's standard rules.
std::vector<Variant> all_variants();

}  // namespace fixproof::cases
