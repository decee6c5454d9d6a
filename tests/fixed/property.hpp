/// @file
/// Property checks for numbers of every type. RapidCheck takes seconds to compile for each operand
/// type, so it draws stored integers of only two widths.
#pragma once

#include <cstdint>
#include <functional>
#include <type_traits>
#include <vector>

namespace property {

using Raws = std::vector<std::int64_t>;

/// Whether `check` holds for `operands` numbers with that many fraction bits (8 or 16), drawn by
/// the generator of judge/property/generator.hpp. Prints the smallest counterexample.
bool holds(int fraction_bits, int operands, const std::function<bool(const Raws&)>& check);

/// Whether `check` holds for two lists of numbers.
bool holds_for_lists(int fraction_bits, const std::function<bool(const Raws&, const Raws&)>& check);

/// Whether `check` holds for the parts of a decimal text: its sign (true if negative), its whole
/// part and its fraction digits.
bool holds_for_parts(const std::function<bool(bool, std::uint16_t, std::uint64_t)>& check);

template <class Number>
Number number_of(std::int64_t raw) {
  return Number::from_raw(static_cast<typename Number::raw_type>(raw));
}

template <class Number>
std::vector<Number> numbers_of(const Raws& raws) {
  std::vector<Number> numbers;
  for (const std::int64_t raw : raws) numbers.push_back(number_of<Number>(raw));
  return numbers;
}

/// Whether `check`, which takes one to three numbers or two lists, holds for all drawn operands.
template <class Number, class Check>
bool for_all(Check check) {
  constexpr int bits = Number::fraction_bits;
  const auto operand = [](const Raws& raws, std::size_t i) { return number_of<Number>(raws[i]); };
  if constexpr (std::is_invocable_v<Check, Number>) {
    return holds(bits, 1, [&](const Raws& x) { return check(operand(x, 0)); });
  } else if constexpr (std::is_invocable_v<Check, Number, Number>) {
    return holds(bits, 2, [&](const Raws& x) { return check(operand(x, 0), operand(x, 1)); });
  } else if constexpr (std::is_invocable_v<Check, Number, Number, Number>) {
    return holds(bits, 3,
                 [&](const Raws& x) { return check(operand(x, 0), operand(x, 1), operand(x, 2)); });
  } else {
    return holds_for_lists(bits, [&](const Raws& a, const Raws& b) {
      return check(numbers_of<Number>(a), numbers_of<Number>(b));
    });
  }
}

}  // namespace property
