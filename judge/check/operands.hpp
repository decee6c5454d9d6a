/// @file
/// The operands of a judged case: words of the results' format, or what a conversion or function
/// takes.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "judge/check/word.hpp"
#include "oracle/decimal.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::check {

/// Tells whether cases are judged by their exact value, not by their words: those of conversions,
/// of functions of real numbers and of mul_div.
constexpr bool is_judged_by_value(cases::Operation operation) {
  return cases::is_conversion(operation) || cases::is_function(operation) ||
         operation == cases::Operation::mul_div;
}

/// The operand of a conversion, or the operands and the exact result of a function.
struct Converted {
  std::string text;                      ///< the operands as they stand on their line
  std::optional<oracle::Ratio> value;    ///< empty for NaN and infinities, outside a domain, and
                                         ///< for a zero divisor
  int sign = 0;                          ///< without a value: -1 or 1 for an infinity or what is
                                         ///< divided by zero, 0 for NaN
  std::array<std::uint64_t, 3> words{};  ///< the operands of a function
};

/// Parses the operands of a conversion or function, remainders included.
/// @throws UsageError describing the defect of the line
Converted parse_converted(std::string_view line, const cases::Variant& variant);

/// Returns the operand as a reader knows it: words and doubles with their value, decimals as they
/// are.
std::string text_of(const Converted& operand, const cases::Variant& variant);

/// Refers to the operands of a case, which must outlive it.
class Operands {
 public:
  template <class Words>
  requires std::convertible_to<const Words&, std::span<const std::uint64_t>> Operands(
      const Words& words)
      : words_(words) {}
  Operands(const Converted& converted) : converted_(&converted) {}

  /// Of any other operation.
  [[nodiscard]] std::span<const std::uint64_t> words() const { return words_; }
  /// Null unless is_judged_by_value().
  [[nodiscard]] const Converted* converted() const { return converted_; }

  /// The sign that decides the result of a case without one: that of a dividend, a product, a
  /// radicand or an infinity.
  [[nodiscard]] int sign(const cases::Format& format) const {
    if (converted_ != nullptr) return converted_->sign;
    if (words_[0] == 0) return 0;
    return is_negative(words_[0], format) ? -1 : 1;
  }

 private:
  std::span<const std::uint64_t> words_;
  const Converted* converted_ = nullptr;
};

}  // namespace fixproof::check
