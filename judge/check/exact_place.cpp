#include "judge/check/exact_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "judge/check/exact_ulps.hpp"

namespace fixproof::check {

namespace {

using cases::Operation;
using oracle::Integer;

/// An exact result in ulps: `floor` + `part` / `whole`, or the root of `floor` squared + `part`.
template <class Number>
struct Exact {
  Number floor;
  Number part;
  Number whole;  ///< above 0 for a ratio, 0 for a root
};

template <class Number>
Exact<Number> exact_of(Operation operation, const Number& a, const Number& b, const Number& one,
                       const Number& floor) {
  switch (operation) {
    case Operation::mul:
      return {floor, a * b - floor * one, one};
    case Operation::div:
      return b < 0 ? Exact<Number>{floor, floor * b - a * one, -b}
                   : Exact<Number>{floor, a * one - floor * b, b};
    case Operation::sqrt:
      return {floor, a * one - floor * floor, 0};
    default:
      return {floor, 0, 1};
  }
}

double ratio(std::int64_t part, std::int64_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}
double ratio(const Integer& part, const Integer& whole) {
  // The denominator of a decimal can have a thousand digits, more than a double holds.
  const auto leading = [](const Integer& number, int& exponent) {
    constexpr int kept = 100;
    exponent = number == 0 ? 0 : std::max(0, static_cast<int>(msb(number)) - kept);
    const Integer top = number >> exponent;
    return static_cast<double>(top);
  };
  int of_part = 0;
  int of_whole = 0;
  const double quotient = leading(part, of_part) / leading(whole, of_whole);
  return std::ldexp(quotient, of_part - of_whole);
}

template <class Number>
double above_floor(const Exact<Number>& exact) {
  if (exact.part == 0) return 0;
  if (exact.whole != 0) {
    const double fraction = ratio(exact.part, exact.whole);
    // Rounding must not move a fraction across a half.
    const bool below = exact.part < exact.whole - exact.part;
    return below ? std::min(fraction, std::nextafter(0.5, 0)) : std::max(fraction, 0.5);
  }
  const auto part = static_cast<double>(exact.part);
  const auto floor = static_cast<double>(exact.floor);
  // The difference of the root and its floor, computed without cancellation. The root is above
  // floor + 1/2 if and only if the part is above the floor.
  const double fraction = part / (std::sqrt(floor * floor + part) + floor);
  return exact.part > exact.floor ? std::max(fraction, 0.5)
                                  : std::min(fraction, std::nextafter(0.5, 0));
}

template <class Number>
void fill(ExactPlace& place, const Exact<Number>& exact) {
  place.exact = exact.part == 0;
  place.tie = !place.exact && exact.part == exact.whole - exact.part;
  place.fraction = above_floor(exact);
}

/// Returns a fraction with a long denominator, to five digits; next to a half, the distance from
/// it.
std::string fraction_text(const Integer& part, const Integer& whole) {
  const Integer above_half = 2 * part - whole;
  const double distance = ratio(abs(above_half), 2 * whole);
  const double below = ratio(whole - part, whole);
  constexpr double rounds_to_one = 5e-6;
  if (below < rounds_to_one) return fmt::format(" + 1 - {:.1g}", below);
  if (distance >= 1.0 / 1024) return fmt::format(" + {:.5g}", ratio(part, whole));
  if (above_half == 0) return " + 1/2";
  return fmt::format(" + 1/2 {} {:.1g}", above_half < 0 ? '-' : '+', distance);
}

/// Returns the exact result, which must exist, in integers of any size.
Exact<Integer> wide_exact(const cases::Variant& variant, const Operands& operands) {
  const auto floor = exact_ulps(variant, operands, oracle::Rounding::floor);
  if (const ValuedCase* valued = operands.valued()) {
    const oracle::Ratio unit = unit_of(variant.format);
    const Integer denominator = valued->value->denominator * unit.numerator;
    return {*floor, valued->value->numerator * unit.denominator - *floor * denominator,
            denominator};
  }
  const auto words = operands.words();
  const auto wide = variant.format.as<oracle::Format>();
  const Integer a = oracle::ulps(words[0], wide);
  const Integer b = oracle::ulps(words.back(), wide);
  return exact_of<Integer>(variant.operation, a, b, oracle::one(wide), *floor);
}

}  // namespace

CaseKind ExactPlace::kind(bool overflows) const {
  if (!has_result) return CaseKind::no_result;
  if (overflows) return CaseKind::overflow;
  if (exact) return CaseKind::exact;
  if (tie) return CaseKind::tie;
  return std::fabs(fraction - 0.5) < 1.0 / 1024 ? CaseKind::near_tie : CaseKind::between;
}

ExactPlace exact_place(const cases::Variant& variant, const Operands& operands) {
  constexpr auto down = oracle::Rounding::floor;
  const bool by_words = operands.valued() == nullptr;
  const bool narrow = by_words && variant.format == cases::q16_16;
  const auto words = operands.words();
  const auto ulps = narrow ? narrow_ulps(variant.operation, words, down) : std::nullopt;
  const auto floor =
      ulps ? std::optional(narrow_word(*ulps)) : rounded_result(variant, operands, down);
  if (!floor) {
    return {.has_result = false, .negative = operands.sign(variant.format) < 0, .floor = {}};
  }
  ExactPlace place{.negative = floor->negative, .floor = *floor};
  if (by_words && !is_rounded(variant)) return place;
  if (!narrow) {
    fill(place, wide_exact(variant, operands));
    return place;
  }
  const std::int64_t a = static_cast<std::int32_t>(words[0]);
  const std::int64_t b = static_cast<std::int32_t>(words.back());
  fill(place, exact_of<std::int64_t>(variant.operation, a, b, 65536, *ulps));
  return place;
}

std::string exact_text(const cases::Variant& variant, const Operands& operands) {
  if (!rounded_result(variant, operands, oracle::Rounding::floor)) return "none";
  const auto [floor, part, whole] = wide_exact(variant, operands);
  if (part == 0) return floor.str();
  if (whole == 0) {
    return fmt::format("{} + {:.5f}", floor.str(), above_floor<Integer>({floor, part, whole}));
  }
  if ((whole - 1) >> 64 != 0) return floor.str() + fraction_text(part, whole);
  const Integer common = gcd(part, whole);
  return fmt::format("{} + {}/{}", floor.str(), (part / common).str(), (whole / common).str());
}

std::string_view name_of(CaseKind kind, cases::Operation operation) {
  constexpr std::array<std::string_view, 5> names{"exact", "tie", "near tie", "between",
                                                  "overflow"};
  if (kind != CaseKind::no_result) return names.at(static_cast<std::size_t>(kind));
  switch (operation) {
    case cases::Operation::sqrt:
      return "negative operand";
    case cases::Operation::from_binary64:
      return "not finite";
    default:
      return cases::is_function(operation) ? "outside domain" : "divide by zero";
  }
}

}  // namespace fixproof::check
