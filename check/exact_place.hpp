/// @file
/// The position of a case's exact result relative to the words around it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "cases/variant.hpp"

namespace fixproof::check {

enum class CaseKind : std::uint8_t {
  exact,      ///< a whole number of ulps
  tie,        ///< halfway between two
  near_tie,   ///< less than 1/1024 ulp from halfway
  between,    ///< any other fraction
  overflow,   ///< the rounded result does not fit a word
  no_result,  ///< a zero divisor, or the root of a negative number
};
inline constexpr std::size_t case_kinds = 6;

/// An exact result in ulps: `floor` + `part` / `whole`. A root is not a ratio and has `whole` 0.
struct ExactPlace {
  bool has_result = true;
  bool negative = false;  ///< the result is below 0; without a result, the first operand is
  std::int64_t floor = 0;
  std::int64_t part = 0;
  std::int64_t whole = 1;
  double fraction = 0;  ///< above the floor, in double precision

  /// `overflows` tells whether the rounded result does not fit a word.
  [[nodiscard]] CaseKind kind(bool overflows) const;
  /// Returns the result as text: `-1 + 1/2`, `46340 + 0.95001`.
  [[nodiscard]] std::string text() const;
};

/// Returns the exact result of a judged operation.
ExactPlace exact_place(cases::Operation operation, std::span<const std::uint32_t> words);

/// Returns the name of a kind. The name for a missing result depends on the operation.
std::string_view name_of(CaseKind kind, cases::Operation operation);

}  // namespace fixproof::check
