/// @file
/// The number types that `prove type` asks about, with their rules as docs/formats.md has them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/check/rules.hpp"
#include "judge/code/quotient_claim.hpp"

namespace fixproof::judge {

/// What happens to a result out of range: policy::range.
enum class Range { wrap, saturate, trap };

/// A number type. Its results must be what `check` and DivideRules call right.
struct NumberType {
  std::string name;   ///< such as `q16_16, floor, wrap`
  std::string cpp{};  ///< as C++ spells it
  cases::Format format{};
  oracle::Rounding products = oracle::Rounding::half_up;
  oracle::Rounding quotients = oracle::Rounding::half_up;
  Range range = Range::wrap;
  DivideRules divide{.has_zero_by_zero = true};
  /// Whether a zero divisor is an error; otherwise the result is the end of the range.
  bool refuses_zero = false;
  /// Whether a quotient out of range is an error, whatever the range says.
  bool refuses_quotients = false;

  /// The rules of an operation on its numbers; those of `mul` also for what has no name in `check`.
  [[nodiscard]] check::Rules rules(cases::Operation operation) const;
};

/// Returns a format under the default rules but for these.
NumberType number_type(const cases::Format& format, oracle::Rounding rounding, Range range);

/// The formats that are asked about.
std::span<const cases::Format> proven_formats();
/// The presets of q16_16 for the eight builds of FIXED.ASM.
std::vector<NumberType> build_types();

/// Every rounding of the type.
std::span<const oracle::Rounding> type_roundings();
std::string_view name_of(Range range);

}  // namespace fixproof::judge
