/// @file
/// Throws the errors of fixed/error.hpp with their text, "fixed-point overflow: operator*(200,
/// 300)".
///
/// Without exceptions (-fno-exceptions) it writes the text to stderr and aborts; under
/// -ffreestanding it executes a trap instruction. FIXED_ON_ERROR replaces all of this, and then no
/// text of the operands is made. Code for a GPU always executes a trap instruction.
#pragma once

#include <cstddef>

#include "fixed/detail/decimal.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/gpu.hpp"
#include "fixed/detail/other_floats.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/trap.hpp"

#if defined(FIXED_ON_ERROR) || __STDC_HOSTED__
#include "fixed/detail/throw.hpp"
#endif
#if !defined(FIXED_ON_ERROR) && __STDC_HOSTED__
#include <array>
#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

#include "fixed/error.hpp"
#endif

namespace fixproof {

class overflow_error;
class divide_error;
class domain_error;

namespace detail {

/// A stored integer that prints as its value.
template <class Raw, int FractionBits>
struct operand {
  Raw raw;
};

/// The number of terms of a sum: an operand of dot().
struct term_count {
  std::size_t terms;
};

#if defined(FIXED_GPU) || (!defined(FIXED_ON_ERROR) && !__STDC_HOSTED__)

// constexpr, because nvcc makes such a function for a GPU, too.
template <class Error, class... Operands>
[[noreturn]] constexpr void raise(const char* /*what*/, const char* /*operation*/,
                                  Operands... /*operands*/) noexcept {
  trap();
}

#elif defined(FIXED_ON_ERROR)

template <class Error, class... Operands>
[[noreturn]] void raise(const char* what, const char* operation, Operands... /*operands*/) {
  FIXED_ON_ERROR(what, operation);
}

#else

template <class Raw, int FractionBits>
std::string describe(operand<Raw, FractionBits> x) {
  std::array<char, max_decimal_chars<Raw, FractionBits> > text{};
  return {text.data(), write_decimal<FractionBits>(text.data(), x.raw)};
}

inline std::string describe(term_count x) { return std::to_string(x.terms) + " terms"; }

std::string describe(std::integral auto x) { return std::to_string(x); }

std::string describe(binary_float auto x) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

std::string describe(wide_float auto x) { return describe(static_cast<double>(x)); }

/// @param what      "overflow", "divide error"
/// @param operation as in the source: "operator+", "sqrt"
template <class Error, class... Operands>
[[noreturn]] void raise(std::string_view what, std::string_view operation, Operands... operands) {
  std::string text = "fixed-point ";
  text.append(what).append(": ").append(operation);
  if constexpr (sizeof...(operands) > 0) {
    const char* separator = "(";
    for (const std::string& operand : {describe(operands)...}) {
      text.append(separator).append(operand);
      separator = ", ";
    }
    text += ')';
  }
  throw_error<Error>(text.c_str());
}

#endif

/// Raises an overflow error for an operation on stored integers.
template <int FractionBits, class... Raws>
[[noreturn]] constexpr void raise_overflow(const char* operation, Raws... operands) {
  raise<overflow_error>("overflow", operation, operand<Raws, FractionBits>{operands}...);
}

}  // namespace detail
}  // namespace fixproof
