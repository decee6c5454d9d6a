/// @file
/// Errors in units of the last place, added up.
#pragma once

#include <array>
#include <cstdint>

namespace fixproof::measure {

/// How often errors of each size came: sixteen buckets of one width, half of them on each side of
/// 0. The width doubles until all errors have found a place.
class ErrorHistogram {
 public:
  static constexpr std::size_t buckets = 16;

  void add(double error);

  /// Bucket i holds errors from -span + i * span / 8 to a bucket's width more. What lies between
  /// two is in the one nearer 0; 0 itself is in bucket 8.
  [[nodiscard]] double span() const { return span_; }
  [[nodiscard]] const std::array<std::uint64_t, buckets>& counts() const { return counts_; }

 private:
  static constexpr double narrowest = 0.5;

  void widen();

  double span_ = narrowest;
  std::array<std::uint64_t, buckets> counts_{};
};

/// What is said of an operation's errors, each its result less the exact one.
class ErrorStatistics {
 public:
  /// @param correct whether no other word is nearer to the exact result
  void add(double error, bool correct);

  [[nodiscard]] std::uint64_t cases() const { return cases_; }
  /// Of the magnitudes.
  [[nodiscard]] double max() const { return max_; }
  /// The bias: of the errors with their signs.
  [[nodiscard]] double mean() const;
  /// The standard error of that mean, of cases taken at random: rms / sqrt(cases), a little more
  /// where there is a bias.
  [[nodiscard]] double mean_error() const;
  [[nodiscard]] double root_mean_square() const;
  /// The share correctly rounded, 0 ... 1.
  [[nodiscard]] double correct() const;
  [[nodiscard]] const ErrorHistogram& histogram() const { return histogram_; }

 private:
  [[nodiscard]] double of_cases(double sum) const;

  std::uint64_t cases_ = 0;
  std::uint64_t correct_ = 0;
  double max_ = 0;
  double sum_ = 0;
  double squares_ = 0;
  ErrorHistogram histogram_;
};

}  // namespace fixproof::measure
