/// @file
/// The position of a case's exact result relative to the words around it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "judge/check/rules.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::check {

enum class CaseKind : std::uint8_t {
  exact,      ///< a whole number of ulps
  tie,        ///< halfway between two
  near_tie,   ///< less than 1/1024 ulp from halfway
  between,    ///< any other fraction
  overflow,   ///< the rounded result does not fit a word
  no_result,  ///< a zero divisor, a negative radicand, not finite, or outside the domain
};
inline constexpr std::size_t case_kinds = 6;

/// Where an exact result lies among the words.
struct ExactPlace {
  bool has_result = true;
  bool negative = false;  ///< the result is below 0; without a result, Operands::sign() is
  Rounded floor;          ///< the result rounded down
  bool exact = true;      ///< a whole number of ulps
  bool tie = false;       ///< halfway between two
  double fraction = 0;    ///< ulps above the floor: below 1/2 if and only if the exact fraction is

  /// `overflows` tells whether the rounded result does not fit a word.
  [[nodiscard]] CaseKind kind(bool overflows) const;
};

/// Returns the place of the exact result of a judged operation.
ExactPlace exact_place(const cases::Variant& variant, const Operands& operands);

/// Returns the exact result in ulps as text: `-1 + 1/2`, `46340 + 0.95001`, `none`.
std::string exact_text(const cases::Variant& variant, const Operands& operands);

/// Returns the name of a kind. The name for a missing result depends on the operation.
std::string_view name_of(CaseKind kind, cases::Operation operation);

}  // namespace fixproof::check
