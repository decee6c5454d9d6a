/// @file
/// The operations whose accuracy is measured, their implementations and their exact results.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/integer.hpp"

namespace fixproof::measure {

/// The operands of one case.
using CaseWords = std::span<const std::uint32_t>;

/// An exact result in ulps, as a ratio. An irrational result is rounded down by less than 2^-40
/// ulp.
struct ExactResult {
  oracle::Integer numerator;
  oracle::Integer denominator;  ///< positive
};

struct Subject {
  std::string name;  ///< a preset of the type, a library, float or double
  std::string
      alike;  ///< presets with the same results wherever the exact result fits; may be empty
  /// The result in ulps, a whole number if it is a word; nothing for a divide error.
  std::optional<double> (*answer)(CaseWords in);
};

/// The random operands of an operation.
enum class OperandKind {
  factors,    ///< 24 uniform bits, so that the product fits
  terms,      ///< pairs of a sum of products; 23 uniform bits, so that the sum fits
  quotients,  ///< uniform words, and 28 uniform bits (up to 2048)
  radicand,   ///< uniform words that are not negative
  angle,      ///< every tenth of a degree of a turn, and no random operands
  radians,    ///< uniform words
};

struct MeasuredOperation {
  std::string name;
  OperandKind kind;
  std::size_t words;  ///< words per case
  /// Empty if there is no result: a zero divisor or the root of a negative number.
  std::optional<ExactResult> (*exact)(CaseWords in);
  std::vector<Subject> subjects;
};

/// All operations with their distinct subjects, including the libraries that are built in.
std::vector<MeasuredOperation> measured_operations();

/// A library's subject for a named operation; empty if the library lacks it or is not built in.
std::optional<Subject> libfixmath_subject(const std::string& operation);
std::optional<Subject> freetype_subject(const std::string& operation);

/// A function of one or two words of 16.16.
using WordFunction = std::uint32_t (*)(std::uint32_t x, std::uint32_t y);
/// A library's function with a name of the command line; null if the library lacks it or is not
/// built in.
WordFunction libfixmath_function(std::string_view function);
WordFunction freetype_function(std::string_view function);

bool has_libfixmath();
bool has_freetype();

}  // namespace fixproof::measure
