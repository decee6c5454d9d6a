/// @file
/// Where the exact result of a case lies: what makes a case easy or hard.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "cases/variant.hpp"

namespace fixproof::check {

/// Every case is of one kind.
enum class CaseKind : std::uint8_t {
  exact,      ///< a whole number of ulps
  tie,        ///< halfway between two
  near_tie,   ///< less than 1/1024 ulp beside halfway
  between,    ///< anywhere else
  overflow,   ///< the rounded result does not fit a word
  no_result,  ///< a zero divisor, the root of a negative number
};
inline constexpr std::size_t case_kinds = 6;

/// An exact result in ulps: `floor` + `part` / `whole`. A root, which is no ratio, has `whole` 0.
struct ExactPlace {
  bool has_result = true;
  bool negative = false;  ///< the result is below 0; where there is none, the first operand is
  std::int64_t floor = 0;
  std::int64_t part = 0;
  std::int64_t whole = 1;
  double fraction = 0;  ///< above the floor, to the precision of a double

  /// `overflows`: whether the result does not fit when it is rounded.
  [[nodiscard]] CaseKind kind(bool overflows) const;
  /// As people read it: `-1 + 1/2`, `46340 + 0.95001`.
  [[nodiscard]] std::string text() const;
};

/// Of mul, div and sqrt.
ExactPlace exact_place(cases::Operation operation, std::span<const std::uint32_t> words);

/// The name of a kind; what has no result is named by the operation.
std::string_view name_of(CaseKind kind, cases::Operation operation);

}  // namespace fixproof::check
