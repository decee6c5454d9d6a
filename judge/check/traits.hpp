/// @file
/// What can be said of a case and of its result, as sets of bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "judge/check/exact_place.hpp"
#include "judge/check/rules.hpp"

namespace fixproof::check {

/// A judged case with all that traits depend on.
struct TraitCase {
  std::array<std::uint64_t, 2> words{};
  ExactPlace place;
  CaseKind kind = CaseKind::exact;
  Said expected;
  Said said;
  cases::Format format{};    ///< of the results
  cases::Format operands{};  ///< of the words
};

/// Bit i is set if trait i holds.
using TraitSet = std::uint64_t;
inline constexpr std::size_t max_traits = 64;

/// The part of a case that a trait describes.
enum class About : std::uint8_t { first, second, either, both, kind, sign };
inline constexpr std::size_t parts_of_case = 6;

/// The number of operands that traits describe: none of conversions, functions and sums.
constexpr std::size_t words_of(const cases::Variant& v) {
  const bool has_none = cases::is_conversion(v.operation) || cases::is_function(v.operation) ||
                        cases::is_sum(v.operation) || v.operation == cases::Operation::mul_div;
  return has_none ? 0 : cases::words_in(v.operation);
}

/// The number of traits of a case. They depend on the operands and the exact result only.
std::size_t case_trait_count();
TraitSet case_traits(const cases::Variant& variant, const TraitCase& of);
About about(std::size_t case_trait);
/// Completes "every wrong case": `has divisor 80000000`, `is an exact tie`.
std::string case_trait_text(const cases::Variant& variant, std::size_t case_trait);

/// The name of an operand with its article: `a divisor`. `either` is `an operand`.
std::string_view noun_of(cases::Operation operation, About operand);

/// The traits of a wrong result beside the expected one.
TraitSet result_traits(const TraitCase& of);
/// Completes "every wrong result": `is 1 ulp too low`.
std::string result_trait_text(const cases::Format& format, std::size_t result_trait);

}  // namespace fixproof::check
