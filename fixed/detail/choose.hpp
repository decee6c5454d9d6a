/// @file
/// Choices without a branch. Operands of all signs and sizes make branches hard to predict, and a
/// wrong prediction takes as long as a function.
#pragma once

#include <type_traits>

namespace fixproof::detail {

/// condition ? a : b. Both are computed.
template <class T>
constexpr T chosen(bool condition, const T& a, const T& b) noexcept {
  if constexpr (std::is_integral_v<T>) {
    const T mask = T{0} - T{condition};
    return b ^ ((a ^ b) & mask);
  } else {
    return condition ? a : b;
  }
}

}  // namespace fixproof::detail
