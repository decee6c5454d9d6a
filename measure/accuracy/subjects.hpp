/// @file
/// Operations whose accuracy is measured, who computes them, and what is exact.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "oracle/integer.hpp"

namespace fixproof::measure {

/// Operands of one case, as words.
using CaseWords = std::span<const std::uint32_t>;

/// An exact result in ulps, as a ratio. Results that are no ratio come as one that is less than
/// 2^-40 ulp too low.
struct ExactResult {
  oracle::Integer numerator;
  oracle::Integer denominator;  ///< positive
};

/// One implementation.
struct Subject {
  std::string name;   ///< a preset of the type, a library, float or double
  std::string alike;  ///< presets that return the same wherever the exact result fits; may be empty
  /// The result in ulps, a whole number where it is a word; nothing for a divide error.
  std::optional<double> (*answer)(CaseWords in);
};

/// What operands an operation is given besides those of scenes.
enum class OperandKind {
  factors,    ///< uniform: 24 bits, so that the product fits
  terms,      ///< pairs of a sum of products; uniform: 23 bits, so that the sum fits
  quotients,  ///< uniform: every word as likely; and 28 bits, to 2048
  radicand,   ///< uniform: every word that is not negative as likely
  angle,      ///< every tenth of a degree of a turn, nothing else
  radians,    ///< uniform: every word as likely
};

struct MeasuredOperation {
  std::string name;
  OperandKind kind;
  std::size_t words;  ///< of a case
  /// Nothing where there is no result: a zero divisor, the root of a negative number.
  std::optional<ExactResult> (*exact)(CaseWords in);
  std::vector<Subject> subjects;
};

/// All of them, with the subjects that differ, libraries among them where they are built in.
std::vector<MeasuredOperation> measured_operations();

/// A library's form of an operation of that name; nothing where it has none, or is not built in.
std::optional<Subject> libfixmath_subject(const std::string& operation);
std::optional<Subject> freetype_subject(const std::string& operation);

/// Whether they are built in.
bool has_libfixmath();
bool has_freetype();

}  // namespace fixproof::measure
