/// @file
/// The results of a function as a curve: their mean error and, for a function of one number, their
/// order and symmetry.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/check/judged_case.hpp"

namespace fixproof::check {

/// Pairs of results, and how many of them are wrong.
struct FlawedPairs {
  std::uint64_t pairs = 0;
  std::uint64_t wrong = 0;
  std::string first;  ///< the operand or operands of the first wrong pair
};

/// A function of two numbers has only a mean error.
struct CurveFigures {
  double mean_error = 0;  ///< in ulps, of the magnitudes
  FlawedPairs order;      ///< neighbours whose results are in the wrong order
  FlawedPairs symmetry;   ///< operands x and -x whose results break the symmetry
};

/// A line for the mean error, and one for each property that a pair breaks.
std::string text_of(const CurveFigures& figures);

class Curve {
 public:
  explicit Curve(const cases::Variant& variant)
      : operand_(operand_format(variant)),
        result_(variant.format),
        operands_(operands_of(variant)) {}

  /// Adds a result in range. `off` is its error in ulps, `exact` the word of the rounded result.
  void add(const JudgedCase& one, double off, std::uint64_t exact);

  /// Empty if there is no result in range.
  [[nodiscard]] std::optional<CurveFigures> figures() const;

 private:
  struct Point {
    std::int64_t operand;
    std::int64_t exact;
    std::int64_t said;
  };

  [[nodiscard]] FlawedPairs order(const std::vector<Point>& sorted) const;
  [[nodiscard]] FlawedPairs symmetry(const std::vector<Point>& sorted) const;
  [[nodiscard]] std::string name_of(std::int64_t operand) const;

  cases::Format operand_;
  cases::Format result_;
  std::size_t operands_;
  std::uint64_t count_ = 0;
  double sum_ = 0;
  std::vector<Point> points_;
};

}  // namespace fixproof::check
