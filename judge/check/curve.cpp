#include "judge/check/curve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/plain_text.hpp"

namespace fixproof::check {

namespace {

/// The value of a word of at most 32 bits, in ulps.
std::int64_t ulps_of(std::uint64_t word, const cases::Format& format) {
  return static_cast<std::int64_t>(oracle::ulps(word, format.as<oracle::Format>()));
}

}  // namespace

std::string text_of(const CurveFigures& figures) {
  const auto& [mean_error, order, symmetry] = figures;
  std::string text = fmt::format("  {:<16} {:.5f} ulp in range\n", "mean error", mean_error);
  if (order.wrong != 0) {
    text += fmt::format("  {:<16} {} of {} neighbours are in the wrong order; first {}\n", "order",
                        support::grouped(order.wrong), support::grouped(order.pairs), order.first);
  }
  if (symmetry.wrong != 0) {
    text += fmt::format("  {:<16} broken by {} of {} pairs of x and -x; first x {}\n", "symmetry",
                        support::grouped(symmetry.wrong), support::grouped(symmetry.pairs),
                        symmetry.first);
  }
  return text;
}

void Curve::add(const JudgedCase& one, double off, std::uint64_t exact) {
  ++count_;
  sum_ += off;
  if (operands_ != 1) return;
  points_.push_back({ulps_of(one.valued->words[0], operand_), ulps_of(exact, result_),
                     ulps_of(*one.said, result_)});
}

std::optional<CurveFigures> Curve::figures() const {
  if (count_ == 0) return std::nullopt;
  std::vector<Point> sorted = points_;
  std::ranges::stable_sort(sorted, {}, &Point::operand);
  sorted.erase(std::unique(sorted.begin(), sorted.end(),
                           [](const Point& a, const Point& b) { return a.operand == b.operand; }),
               sorted.end());
  return CurveFigures{sum_ / static_cast<double>(count_), order(sorted), symmetry(sorted)};
}

FlawedPairs Curve::order(const std::vector<Point>& sorted) const {
  const auto is_wrong = [](const Point& a, const Point& b) {
    return (a.exact < b.exact && a.said > b.said) || (a.exact > b.exact && a.said < b.said);
  };
  FlawedPairs found;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    ++found.pairs;
    if (!is_wrong(sorted[i - 1], sorted[i]) || found.wrong++ != 0) continue;
    found.first =
        fmt::format("{} and {}", name_of(sorted[i - 1].operand), name_of(sorted[i].operand));
  }
  return found;
}

FlawedPairs Curve::symmetry(const std::vector<Point>& sorted) const {
  FlawedPairs found;
  const auto zero = std::ranges::lower_bound(sorted, 1, {}, &Point::operand);
  for (auto point = zero; point != sorted.end(); ++point) {
    const auto mirror = std::ranges::lower_bound(sorted, -point->operand, {}, &Point::operand);
    if (mirror->operand != -point->operand) continue;
    const bool is_odd = mirror->exact == -point->exact;
    if (!is_odd && mirror->exact != point->exact) continue;
    ++found.pairs;
    if (mirror->said == (is_odd ? -point->said : point->said)) continue;
    if (found.wrong++ == 0) found.first = name_of(point->operand);
  }
  return found;
}

std::string Curve::name_of(std::int64_t operand) const {
  return hex_text(static_cast<std::uint64_t>(operand) & cases::all_ones(operand_), operand_);
}

}  // namespace fixproof::check
