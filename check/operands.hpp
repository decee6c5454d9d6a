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

#include "cases/variant.hpp"
#include "check/word.hpp"
#include "oracle/decimal.hpp"

namespace fixproof::check {

/// The operand of a conversion, or the operands and the result of a function.
struct Converted {
  std::string text;                      ///< the operands as they stand on their line
  std::optional<oracle::Ratio> value;    ///< empty for NaN and infinities, and outside a domain
  int sign = 0;                          ///< without a value: -1 or 1 for an infinity, 0 for NaN
  std::array<std::uint64_t, 2> words{};  ///< the operands of a function
};

/// Parses the operands of a conversion or function.
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
  /// Null unless the operation is a conversion or function.
  [[nodiscard]] const Converted* converted() const { return converted_; }

  /// The sign that decides the result of a case without one: that of a dividend, a radicand or an
  /// infinity.
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
