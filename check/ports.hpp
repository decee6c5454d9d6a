/// @file
/// The arithmetic of games and libraries that people port, as named rules.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "check/rules.hpp"

namespace fixproof::check {

/// What one routine of a program computes, for every operand. docs/ports.md describes each.
struct PortRule {
  /// Returns the result of two's complement operands, DE for a divide error.
  /// @param fraction_bits the shift: 1 ... 32
  using Result = Said (*)(std::span<const std::int64_t> operands, int fraction_bits);

  std::string_view name{};     ///< of the program, as options take it
  std::string_view routine{};  ///< its name in the program
  cases::Operation operation;  ///< mul, div or mul_div
  std::string_view text;       ///< what it does, in one line; {F} stands for the shift
  Result result;
  /// The general rules. If `is_general` is false, some results differ from them.
  oracle::Rounding rounding;
  Overflow overflow;
  NoResult no_result = NoResult::error;
  bool is_general = true;
  /// A routine with a shift is for every signed format of 32 bits with a fraction, others
  /// for 16.16.
  bool has_shift = false;
  /// Doom's comparison before a divide: abs(a) >> 14 >= abs(b), in 32 bits that wrap, gives an end
  /// of the range by the sign of a ^ b. The general rules are for all other operands.
  bool has_guard = false;
  /// The second operand is no two's complement: bit 31 is its sign, and bits 0 to 15 its magnitude.
  bool has_signed_fraction = false;

  [[nodiscard]] bool is_for(cases::Operation of, const cases::Format& format) const;
};

/// Every rule, by program.
std::span<const PortRule> port_rules();

/// Returns what the rule expects, beside its general rules.
Rules rules_of(const PortRule& rule, const cases::Format& format);

/// Returns the result of the rule for operands of its operation and of a format that it is for.
Said result_of(const PortRule& rule, const cases::Format& format, const Operands& operands);

/// Returns the words of two numbers as the rule reads them, in two's complement.
std::array<std::uint64_t, 2> read_words(const PortRule& rule,
                                        const std::array<std::uint64_t, 2>& words);

/// Returns a line for each rule: name, operation, routine and text.
std::string port_rules_text();

}  // namespace fixproof::check
