/// \file
/// The plain loops: the whole portable path, and the last elements of every other path.
#pragma once

#include <array>
#include <cstddef>

#include "batch/detail/element.hpp"
#include "batch/detail/report.hpp"
#include "fixed/detail/divide.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// Computes the elements from `i` up to `count`, excluded, with the number type.
/// \param element (index) -> outcome
/// \param store   (index, raw)
template <class Element, class Store>
FIXED_ALWAYS_INLINE void few_elements(std::size_t i, std::size_t count, fault_recorder& found,
                                      const Element& element, const Store& store) noexcept {
  for (; i < count; ++i) {
    const auto one = element(i);
    store(i, one.raw);
    found.note(one.what, i);
  }
}

/// The same, but never inlined, so that callers are small and therefore fast for few elements.
template <class Element, class Store>
FIXED_NOINLINE void each_element(std::size_t i, std::size_t count, fault_recorder& found,
                                 Element element, Store store) noexcept {
  few_elements(i, count, found, element, store);
}

/// Computes blocks of quotients under a policy that never throws, in a loop that compilers
/// vectorise. A second loop finds faults, which are rare. Results are buffered until all operands
/// of a block are read, because an output may be an input.
/// \return the number of elements done; each_element() computes the rest
template <class N, class Element>
FIXED_NOINLINE std::size_t divide_blocks(std::size_t i, const N* n, const N* d, N* to,
                                         std::size_t count, fault_recorder& found,
                                         Element element) noexcept {
  using raw = typename N::raw_type;
  constexpr std::size_t block = 64;
  std::array<raw, block> results;
  for (; count - i >= block; i += block) {
    int suspect = 0;
    for (std::size_t k = 0; k < block; ++k) {
      results[k] = total_divide<raw, N::fraction_bits, N::rules>(n[i + k].raw(), d[i + k].raw());
      suspect |= static_cast<int>(may_be_fault(d[i + k], results[k]));
    }
    if (suspect != 0) {
      for (std::size_t k = 0; k < block; ++k) found.note(element(i + k).what, i + k);
    }
    for (std::size_t k = 0; k < block; ++k) to[i + k] = N::from_raw(results[k]);
  }
  return i;
}

}  // namespace fixproof::detail
