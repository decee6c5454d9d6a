#include "verify/cases/exact_value.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "oracle/format.hpp"
#include "oracle/function.hpp"
#include "oracle/whole_function.hpp"
#include "verify/cases/value.hpp"

namespace fixproof::cases {

namespace {

using oracle::Integer;
using oracle::Ratio;

/// The root of a number that is not negative, exact or halfway between two multiples of 2^-220. An
/// irrational root of words is farther than that from every word and tie.
Ratio root_of(const Ratio& square) {
  constexpr unsigned precision = 220;
  // sqrt(n / d) = sqrt(n d) / d
  const Integer radicand = square.numerator * square.denominator;
  Integer rest;
  const Integer exact = boost::multiprecision::sqrt(radicand, rest);
  if (rest == 0) return {exact, square.denominator};
  const Integer floor = boost::multiprecision::sqrt(radicand << 2 * precision);
  return {2 * floor + 1, square.denominator << (precision + 1)};
}

/// The value of `number` units to a power.
Ratio in_units(const Integer& number, const Ratio& unit, int power) {
  Ratio value{number, 1};
  for (int i = 0; i < power; ++i) {
    value.numerator *= unit.numerator;
    value.denominator *= unit.denominator;
  }
  return value;
}

Ratio negated(const Ratio& value) { return {-value.numerator, value.denominator}; }

/// A function of real numbers, whose formats have units of 2^-F with 0 <= F <= 64.
ExactValue function_of(const cases::Variant& v, const Integer& x, const Integer& y) {
  // In the finer of the two units every operand is whole, and every word and tie of the results is.
  const int from = operand_format(v).fraction_bits;
  const int finer = std::max(from, v.format.fraction_bits);
  const auto function = oracle::function_named(name_of(v.operation)).value();
  return {oracle::function_value(function, x << (finer - from), y << (finer - from), finer)};
}

/// The sum in squares of a part. 1.0 is `one` parts.
Integer sum_of(const cases::Variant& v, std::span<const Integer> x, const Integer& one) {
  switch (v.operation) {
    case Operation::mul_add:
      return x[0] * x[1] + x[2] * one;
    case Operation::lerp:
      return x[0] * one + (x[1] - x[0]) * x[2];
    default: {
      Integer sum = 0;
      for (std::size_t i = 0; i < v.terms; ++i) sum += x[i] * x[v.terms + i];
      return sum;
    }
  }
}

}  // namespace

ExactValue exact_value(const cases::Variant& v, std::span<const std::uint64_t> words) {
  const cases::Format format = operand_format(v);
  const Ratio unit = unit_of(format);
  // Every operand is a whole number of parts: of units, or of ones if the unit is above 1.
  const Ratio part{1, unit.denominator};
  std::vector<Integer> x;
  for (const std::uint64_t word : words) {
    x.push_back(oracle::ulps(word, format.as<oracle::Format>()) * unit.numerator);
  }
  const auto whole = [&](const std::optional<Integer>& result) {
    return result ? ExactValue{in_units(*result, part, 1)} : ExactValue{{}, {}, x[0].sign()};
  };
  switch (v.operation) {
    case Operation::convert:
    case Operation::to_decimal:
      return {in_units(x[0], part, 1)};
    case Operation::add:
      return {in_units(x[0] + x[1], part, 1)};
    case Operation::sub:
      return {in_units(x[0] - x[1], part, 1)};
    case Operation::mul:
      return {in_units(x[0] * x[1], part, 2)};
    case Operation::mul_add:
    case Operation::lerp:
    case Operation::dot:
      return {in_units(sum_of(v, x, part.denominator), part, 2)};
    case Operation::div:
      if (x[1] == 0) return {{}, {}, x[0].sign()};
      return {Ratio{x[1] < 0 ? -x[0] : x[0], abs(x[1])}};
    case Operation::sqrt: {
      const Ratio root = root_of(in_units(abs(x[0]), part, 1));
      if (x[0] < 0) return {{}, negated(root), -1};
      return {root};
    }
    case Operation::fmod:
      return whole(oracle::truncated_remainder(x[0], x[1]));
    case Operation::remainder:
      return whole(oracle::nearest_remainder(x[0], x[1]));
    case Operation::mul_div: {
      const Integer product = x[0] * x[1];
      if (x[2] == 0) return {{}, {}, product.sign()};
      return {in_units(x[2] < 0 ? -product : product, {1, abs(x[2]) * part.denominator}, 1)};
    }
    case Operation::hypot:
    case Operation::hypot3: {
      Integer sum = 0;
      for (const Integer& each : x) sum += each * each;
      return {root_of(in_units(sum, part, 2))};
    }
    default:
      break;
  }
  if (!cases::is_function(v.operation)) {
    throw std::invalid_argument("only operations on numbers are judged, and no routine");
  }
  return function_of(v, x[0], x.size() > 1 ? x[1] : Integer(0));
}

}  // namespace fixproof::cases
