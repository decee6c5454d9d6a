/// @file
/// Statistics of errors in ulps.
#pragma once

#include <array>
#include <cstdint>

namespace fixproof::measure {

/// A histogram of sixteen equal buckets, eight on each side of 0. The width doubles until all
/// errors fit.
class ErrorHistogram {
 public:
  static constexpr std::size_t buckets = 16;

  void add(double error);

  /// Bucket i holds errors from -span + i * span / 8 to one bucket width more. An error on a
  /// boundary counts in the bucket nearer 0, and 0 itself in bucket 8.
  [[nodiscard]] double span() const { return span_; }
  [[nodiscard]] const std::array<std::uint64_t, buckets>& counts() const { return counts_; }

 private:
  static constexpr double narrowest = 0.5;

  void widen();

  double span_ = narrowest;
  std::array<std::uint64_t, buckets> counts_{};
};

/// Statistics of an operation's errors: result minus exact result.
class ErrorStatistics {
 public:
  /// @param correct whether no other word is nearer to the exact result
  void add(double error, bool correct);

  [[nodiscard]] std::uint64_t cases() const { return cases_; }
  /// The largest magnitude.
  [[nodiscard]] double max() const { return max_; }
  /// The bias: the mean of the signed errors.
  [[nodiscard]] double mean() const;
  /// The standard error of the mean for random cases: rms / sqrt(cases), slightly too large if
  /// there is a bias.
  [[nodiscard]] double mean_error() const;
  [[nodiscard]] double root_mean_square() const;
  /// The share of correctly rounded results, 0 ... 1.
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
