#include "check/exact_place.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <stdexcept>

#include "check/rules.hpp"

namespace fixproof::check {

namespace {

std::int64_t signed_ulps(std::uint32_t word) { return static_cast<std::int32_t>(word); }

/// Returns the place of numerator / denominator, given its floor. The denominator is positive.
ExactPlace place_of_ratio(std::int64_t numerator, std::int64_t denominator, std::int64_t floor) {
  ExactPlace place;
  place.negative = numerator < 0;
  place.floor = floor;
  place.part = numerator - floor * denominator;
  place.whole = denominator;
  place.fraction = static_cast<double>(place.part) / static_cast<double>(denominator);
  return place;
}

ExactPlace place_of_root(std::int64_t radicand, std::int64_t floor) {
  ExactPlace place;
  place.floor = floor;
  const std::int64_t rest = radicand - floor * floor;
  if (rest == 0) return place;
  place.whole = 0;
  // The difference of the root and its floor, computed without cancellation.
  place.fraction = static_cast<double>(rest) /
                   (std::sqrt(static_cast<double>(radicand)) + static_cast<double>(floor));
  return place;
}

}  // namespace

CaseKind ExactPlace::kind(bool overflows) const {
  if (!has_result) return CaseKind::no_result;
  if (overflows) return CaseKind::overflow;
  if (whole != 0 && part == 0) return CaseKind::exact;
  if (whole != 0 && 2 * part == whole) return CaseKind::tie;
  return std::fabs(fraction - 0.5) < 1.0 / 1024 ? CaseKind::near_tie : CaseKind::between;
}

std::string ExactPlace::text() const {
  if (!has_result) return "none";
  if (whole == 0) return fmt::format("{} + {:.5f}", floor, fraction);
  if (part == 0) return fmt::to_string(floor);
  const std::int64_t common = std::gcd(part, whole);
  return fmt::format("{} + {}/{}", floor, part / common, whole / common);
}

ExactPlace exact_place(cases::Operation operation, std::span<const std::uint32_t> words) {
  const auto floor = rounded_result(operation, words, oracle::Rounding::floor);
  if (!floor) return {.has_result = false, .negative = words[0] >> 31U != 0};
  if (!is_rounded(operation)) return place_of_ratio(*floor, 1, *floor);
  constexpr std::int64_t one = 65536;
  const std::int64_t a = signed_ulps(words[0]);
  if (operation == cases::Operation::sqrt) return place_of_root(a * one, *floor);
  const std::int64_t b = signed_ulps(words[1]);
  if (operation == cases::Operation::mul) return place_of_ratio(a * b, one, *floor);
  return place_of_ratio(b < 0 ? -a * one : a * one, std::abs(b), *floor);
}

std::string_view name_of(CaseKind kind, cases::Operation operation) {
  constexpr std::array<std::string_view, 5> names{"exact", "tie", "near tie", "between",
                                                  "overflow"};
  if (kind != CaseKind::no_result) return names.at(static_cast<std::size_t>(kind));
  return operation == cases::Operation::sqrt ? "negative operand" : "divide by zero";
}

}  // namespace fixproof::check
