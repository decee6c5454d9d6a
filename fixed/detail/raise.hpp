/// \file
/// Throws the errors of fixed/error.hpp with their text: "fixed-point overflow: operator*(200,
/// 300)".
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

#include "fixed/detail/decimal.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/error.hpp"

namespace fixed::detail {

/// A stored integer that prints as its value.
template <int FractionBits>
struct operand {
  raw_t<FractionBits> raw;
};

template <int FractionBits>
std::string describe(operand<FractionBits> x) {
  std::array<char, max_decimal_chars<FractionBits>> text{};
  return {text.data(), write_decimal<FractionBits>(text.data(), x.raw)};
}

std::string describe(std::integral auto x) { return std::to_string(x); }

std::string describe(binary_float auto x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

/// \param what      "overflow", "divide error"
/// \param operation as in the source: "operator+", "sqrt"
template <class Error, class... Operands>
[[noreturn]] void raise(std::string_view what, std::string_view operation, Operands... operands) {
  std::string text = "fixed-point ";
  text.append(what).append(": ").append(operation);
  if constexpr (sizeof...(Operands) != 0) {
    const char* separator = "(";
    for (const std::string& operand : {describe(operands)...}) {
      text.append(separator).append(operand);
      separator = ", ";
    }
    text += ')';
  }
  throw Error(text);
}

/// Calls raise() for an overflow of an operation on stored integers.
template <int FractionBits, class... Raws>
[[noreturn]] void raise_overflow(std::string_view operation, Raws... operands) {
  raise<overflow_error>("overflow", operation, operand<FractionBits>{operands}...);
}

}  // namespace fixed::detail
