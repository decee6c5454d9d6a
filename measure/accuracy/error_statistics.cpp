#include "measure/accuracy/error_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace fixproof::measure {

void ErrorHistogram::add(double error) {
  while (std::fabs(error) > span_) widen();
  constexpr std::size_t half = buckets / 2;
  const double widths = std::ceil(std::fabs(error) / span_ * half);
  const std::size_t from_zero = widths > 1 ? static_cast<std::size_t>(widths) - 1 : 0;
  ++counts_.at(error < 0 ? half - 1 - from_zero : half + from_zero);
}

void ErrorHistogram::widen() {
  constexpr std::size_t half = buckets / 2;
  std::array<std::uint64_t, buckets> wider{};
  for (std::size_t i = 0; i < half; ++i) {
    wider.at(half + i / 2) += counts_.at(half + i);
    wider.at(half - 1 - i / 2) += counts_.at(half - 1 - i);
  }
  counts_ = wider;
  span_ *= 2;
}

void ErrorStatistics::add(double error, bool correct) {
  ++cases_;
  correct_ += correct ? 1 : 0;
  max_ = std::max(max_, std::fabs(error));
  sum_ += error;
  squares_ += error * error;
  histogram_.add(error);
}

double ErrorStatistics::of_cases(double sum) const {
  return cases_ == 0 ? 0 : sum / static_cast<double>(cases_);
}
double ErrorStatistics::mean() const { return of_cases(sum_); }
double ErrorStatistics::mean_error() const { return std::sqrt(of_cases(of_cases(squares_))); }
double ErrorStatistics::root_mean_square() const { return std::sqrt(of_cases(squares_)); }
double ErrorStatistics::correct() const { return of_cases(static_cast<double>(correct_)); }

}  // namespace fixproof::measure
