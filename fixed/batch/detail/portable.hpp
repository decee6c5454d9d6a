/// @file
/// The plain loops: the whole portable path, and the last elements of every other path.
#pragma once

#include <array>
#include <cstddef>

#include "fixed/batch/detail/element.hpp"
#include "fixed/batch/detail/report.hpp"
#include "fixed/batch/detail/targets.hpp"
#include "fixed/detail/divide.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// Computes the elements from `i` up to `count`, excluded, with the number type.
/// @param element (index, from...) -> outcome. It may have a member blocks() with the arguments
///                (i, count, found, to, from...), which returns the first element that is left.
template <class Element, class Type, class... From>
void each_element(std::size_t i, std::size_t count, fault_recorder& found, const Element& element,
                  Type* to, const From*... from) noexcept {
  if constexpr (requires { element.blocks(i, count, found, to, from...); }) {
    i = element.blocks(i, count, found, to, from...);
  }
  for (; i < count; ++i) {
    const auto one = element(i, from...);
    to[i] = stored<Type>(one.raw);
    found.note(one.what, i);
  }
}

/// The quotient as an element.
struct quotient_element {
  template <class Number>
  constexpr outcome_of<Number> operator()(std::size_t i, const Number* n,
                                          const Number* d) const noexcept {
    return divided(n[i], d[i]);
  }

  /// Computes blocks under a policy that never throws, in a loop that compilers vectorise. A second
  /// loop finds faults, which are rare. Results are buffered until all operands of a block are
  /// read, because an output may be an input.
  /// @return the first element that is left
  template <class Number>
  requires(Number::divide_never_throws&& has_quotient_lanes<Number>) std::size_t
      blocks(std::size_t i, std::size_t count, fault_recorder& found, Number* to, const Number* n,
             const Number* d)
  const noexcept {
    using raw = typename Number::raw_type;
    constexpr std::size_t block = 64;
    std::array<raw, block> results;
    for (; count - i >= block; i += block) {
      int suspect = 0;
      for (std::size_t k = 0; k < block; ++k) {
        results[k] =
            total_divide<raw, Number::fraction_bits, Number::rules>(n[i + k].raw(), d[i + k].raw());
        suspect |= static_cast<int>(may_be_fault(d[i + k], results[k]));
      }
      if (suspect != 0) {
        for (std::size_t k = 0; k < block; ++k) found.note(divided(n[i + k], d[i + k]).what, i + k);
      }
      for (std::size_t k = 0; k < block; ++k) to[i + k] = Number::from_raw(results[k]);
    }
    return i;
  }
};

}  // namespace fixproof::detail
