#include "check/curve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/plain_text.hpp"

namespace fixproof::check {

namespace {

/// The value of a word of at most 32 bits, in ulps.
std::int64_t ulps_of(std::uint64_t word, const cases::Format& format) {
  return static_cast<std::int64_t>(oracle::ulps(word, oracle_format(format)));
}

}  // namespace

void Curve::add(const JudgedCase& one, double off, std::uint64_t exact) {
  sum_ += off;
  points_.push_back({ulps_of(one.converted->words[0], format_), ulps_of(exact, format_),
                     ulps_of(*one.said, format_)});
}

std::string Curve::lines() const {
  if (points_.empty()) return "";
  std::vector<Point> sorted = points_;
  std::ranges::stable_sort(sorted, {}, &Point::operand);
  sorted.erase(std::unique(sorted.begin(), sorted.end(),
                           [](const Point& a, const Point& b) { return a.operand == b.operand; }),
               sorted.end());
  return fmt::format("  {:<16} {:.5f} ulp in range\n", "mean error",
                     sum_ / static_cast<double>(points_.size())) +
         order_line(sorted) + symmetry_line(sorted);
}

std::string Curve::order_line(const std::vector<Point>& sorted) const {
  const auto is_wrong = [](const Point& a, const Point& b) {
    return (a.exact < b.exact && a.said > b.said) || (a.exact > b.exact && a.said < b.said);
  };
  std::uint64_t wrong = 0;
  std::string first;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (!is_wrong(sorted[i - 1], sorted[i])) continue;
    if (wrong++ == 0) {
      first = fmt::format("{} and {}", name_of(sorted[i - 1].operand), name_of(sorted[i].operand));
    }
  }
  if (wrong == 0) return "";
  return fmt::format("  {:<16} {} of {} neighbours are in the wrong order; first {}\n", "order",
                     support::grouped(wrong), support::grouped(sorted.size() - 1), first);
}

std::string Curve::symmetry_line(const std::vector<Point>& sorted) const {
  std::uint64_t pairs = 0;
  std::uint64_t wrong = 0;
  std::string first;
  const auto zero = std::ranges::lower_bound(sorted, 1, {}, &Point::operand);
  for (auto point = zero; point != sorted.end(); ++point) {
    const auto mirror = std::ranges::lower_bound(sorted, -point->operand, {}, &Point::operand);
    if (mirror->operand != -point->operand) continue;
    const bool is_odd = mirror->exact == -point->exact;
    if (!is_odd && mirror->exact != point->exact) continue;
    ++pairs;
    if (mirror->said == (is_odd ? -point->said : point->said)) continue;
    if (wrong++ == 0) first = name_of(point->operand);
  }
  if (wrong == 0) return "";
  return fmt::format("  {:<16} broken by {} of {} pairs of x and -x; first x {}\n", "symmetry",
                     support::grouped(wrong), support::grouped(pairs), first);
}

std::string Curve::name_of(std::int64_t operand) const {
  return hex_text(static_cast<std::uint64_t>(operand) & cases::all_ones(format_), format_);
}

}  // namespace fixproof::check
