/// @file
/// The operands of a judged case: words of the results' format, or operands with the exact value of
/// the result.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/check/word.hpp"
#include "oracle/decimal.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::check {

/// Tells whether cases are judged by their exact value, not by their words: those of conversions,
/// of functions of real numbers, of mul_div and of sums, and all in a format that the type lacks or
/// whose results have another one.
constexpr bool is_judged_by_value(const cases::Variant& v) {
  return cases::is_conversion(v.operation) || cases::is_function(v.operation) ||
         cases::is_sum(v.operation) || v.operation == cases::Operation::mul_div ||
         v.from.has_value() || v.format.is_decimal || v.format.fraction_bits < 0 ||
         v.format.fraction_bits > v.format.word_bits;
}

/// The operands of a case and the exact value of its result.
struct ValuedCase {
  std::string text;                         ///< the operands as they stand on their line
  std::optional<oracle::Ratio> value;       ///< empty for NaN and infinities, outside a domain, and
                                            ///< for a zero divisor
  int sign = 0;                             ///< without a value: -1 or 1 for an infinity or what is
                                            ///< divided by zero, 0 for NaN
  std::vector<std::uint64_t> words{};       ///< the operands that are words
  std::optional<oracle::Ratio> mirrored{};  ///< of a negative radicand: minus the root of its
                                            ///< magnitude
};

/// Parses the operands of a case of any operation that is_judged().
/// @throws UsageError describing the defect of the line
ValuedCase parse_valued(std::string_view line, const cases::Variant& variant);

/// Returns the operand as a reader knows it: words and doubles with their value, decimals as they
/// are.
std::string text_of(const ValuedCase& operand, const cases::Variant& variant);

/// Refers to the operands of a case, which must outlive it.
class Operands {
 public:
  template <class Words>
  requires std::convertible_to<const Words&, std::span<const std::uint64_t>> Operands(
      const Words& words)
      : words_(words) {}
  Operands(const ValuedCase& valued) : valued_(&valued) {}

  /// Of any other case.
  [[nodiscard]] std::span<const std::uint64_t> words() const { return words_; }
  /// Null unless is_judged_by_value().
  [[nodiscard]] const ValuedCase* valued() const { return valued_; }

  /// The sign that decides the result of a case without one: that of a dividend, a product, a
  /// radicand or an infinity.
  [[nodiscard]] int sign(const cases::Format& format) const {
    if (valued_ != nullptr) return valued_->sign;
    if (words_[0] == 0) return 0;
    return is_negative(words_[0], format) ? -1 : 1;
  }

 private:
  std::span<const std::uint64_t> words_;
  const ValuedCase* valued_ = nullptr;
};

}  // namespace fixproof::check
