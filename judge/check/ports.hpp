/// @file
/// The arithmetic of games and libraries that people port, as named rules.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "judge/check/rules.hpp"

namespace fixproof::check {

/// What one routine of a program computes, for every operand. docs/ports.md describes each.
struct PortRule {
  /// Returns the result of operands in two's complement, or DE for a divide error.
  /// @param fraction_bits the shift: 1 ... 32
  using Result = Said (*)(std::span<const std::int64_t> operands, int fraction_bits);

  std::string_view name{};     ///< the program's name in options
  std::string_view routine{};  ///< the routine's name in the program
  cases::Operation operation;  ///< mul, div or mul_div
  std::string_view text;       ///< what the routine does, in one line; {F} stands for the shift
  Result result;
  /// The routine as general rules. If `is_general` is false, some results differ from them.
  oracle::Rounding rounding;
  Overflow overflow;
  NoResult no_result = NoResult::error;
  bool is_general = true;
  /// If true, the rule is for every signed format of 32 bits with a fraction, otherwise for 16.16.
  bool has_shift = false;
  /// Whether Doom's comparison comes before the divide: if abs(a) >> 14 >= abs(b), in 32 bits that
  /// wrap, the result is the end of the range that has the sign of a ^ b. The general rules are for
  /// all other operands.
  bool has_guard = false;
  /// Whether the second operand is not in two's complement: bit 31 is its sign, and bits 0 to 15
  /// are its magnitude.
  bool has_signed_fraction = false;

  /// Tells whether the rule is for an operation in a format.
  [[nodiscard]] bool is_for(const cases::Variant& of) const;
};

/// Returns all rules, those of a program together.
std::span<const PortRule> port_rules();

/// Returns the general rules of a rule, together with the rule itself.
Rules rules_of(const PortRule& rule, const cases::Format& format);

/// Returns the rule's result for operands of its operation, in a format that it is for.
Said result_of(const PortRule& rule, const cases::Format& format, const Operands& operands);

/// Returns the words of two numbers as the rule reads them, in two's complement.
std::array<std::uint64_t, 2> read_words(const PortRule& rule,
                                        const std::array<std::uint64_t, 2>& words);

/// Returns a line for each rule: name, operation, routine and text.
std::string port_rules_text();

}  // namespace fixproof::check
