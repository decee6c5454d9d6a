/// @file
/// Choices without a branch. Operands of all signs and sizes make branches hard to predict, and a
/// wrong prediction takes as long as a function.
#pragma once

#include <type_traits>

namespace fixproof::detail {

/// condition ? a : b. Both are computed.
template <class Type>
constexpr Type chosen(bool condition, const Type& a, const Type& b) noexcept {
  if constexpr (std::is_integral_v<Type>) {
    const Type mask = Type{0} - Type{condition};
    return b ^ ((a ^ b) & mask);
  } else {
    return condition ? a : b;
  }
}

}  // namespace fixproof::detail
