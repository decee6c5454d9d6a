/// @file
/// The results of a function of one number as a curve: their mean error, order and symmetry.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "check/judged_case.hpp"

namespace fixproof::check {

class Curve {
 public:
  explicit Curve(const cases::Format& format) : format_(format) {}

  /// Adds a result in range. `off` is its error in ulps, `exact` the word of the rounded result.
  void add(const JudgedCase& one, double off, std::uint64_t exact);

  /// A line for the mean error; one for neighbours whose results are in the wrong order, and one
  /// for operands x and -x whose results break the symmetry, if there are any.
  [[nodiscard]] std::string lines() const;

 private:
  struct Point {
    std::int64_t operand;
    std::int64_t exact;
    std::int64_t said;
  };

  [[nodiscard]] std::string order_line(const std::vector<Point>& sorted) const;
  [[nodiscard]] std::string symmetry_line(const std::vector<Point>& sorted) const;
  [[nodiscard]] std::string name_of(std::int64_t operand) const;

  cases::Format format_;
  double sum_ = 0;
  std::vector<Point> points_;
};

}  // namespace fixproof::check
