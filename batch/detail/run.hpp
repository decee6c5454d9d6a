/// \file
/// The options of a batch, and how it runs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "batch/detail/portable.hpp"
#include "batch/detail/report.hpp"
#include "batch/detail/spans.hpp"
#include "batch/detail/targets.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/policy.hpp"

namespace fixproof::batch {

/// Options of a batch operation.
struct options {
  /// The path to use; path::portable replaces one that the processor lacks.
  path use = best();
  /// If not empty, entry i is set to whether element i has a fault, and nothing is thrown.
  std::span<bool> marks = {};
};

}  // namespace fixproof::batch

namespace fixproof::detail {

template <class... Ranges>
FIXED_ALWAYS_INLINE std::size_t batch_length(const batch::options& how,
                                             const Ranges&... ranges) noexcept {
  const std::size_t count = shortest(ranges...);
  return how.marks.empty() ? count : (std::min)(count, how.marks.size());
}

FIXED_ALWAYS_INLINE std::span<bool> batch_marks(const batch::options& how,
                                                std::size_t count) noexcept {
  return how.marks.empty() ? how.marks : how.marks.first(count);
}

/// Runs a batch. Computes a few elements one by one. Computes more on the path of `how`, as far as
/// it goes, and the remaining ones with the number type.
/// \tparam few      up to this many elements are faster one by one
/// \tparam has      whether the loops cover the operation
/// \tparam O        the overflow rule of the operation
/// \tparam Fault    the divide errors of the operation
/// \param blocks    (loops, fault_recorder&) -> number of elements done
/// \param element   (index) -> outcome
/// \param store     (index, raw)
/// \param rest      (number of elements done, fault_recorder&), computes the others
/// \param operation the name in the text of an error
template <std::size_t few, bool has, overflow O, divide_fault Fault = divide_fault::none,
          class Blocks, class Element, class Store, class Rest>
FIXED_ALWAYS_INLINE batch::report run_batch(const char* operation, const batch::options& how,
                                            std::size_t count, const Blocks& blocks,
                                            const Element& element, const Store& store,
                                            const Rest& rest) {
  fault_recorder found(batch_marks(how, count));
  if (count <= few) {
    few_elements(0, count, found, element, store);
  } else {
    const std::size_t done =
        on_path<has>(how.use, [&](auto loops) { return blocks(loops, found); });
    if (done < count) rest(done, found);
  }
  return found.template finish<O, Fault>(operation);
}

/// The same, with a plain loop for the remaining elements.
template <std::size_t few, bool has, overflow O, divide_fault Fault = divide_fault::none,
          class Blocks, class Element, class Store>
FIXED_ALWAYS_INLINE batch::report run_batch(const char* operation, const batch::options& how,
                                            std::size_t count, const Blocks& blocks,
                                            const Element& element, const Store& store) {
  return run_batch<few, has, O, Fault>(operation, how, count, blocks, element, store,
                                       [&](std::size_t done, fault_recorder& found) {
                                         each_element(done, count, found, element, store);
                                       });
}

/// Returns a function that stores a raw integer as element i of `to`.
template <class N>
auto store_at(N* to) noexcept {
  return [to](std::size_t i, typename N::raw_type raw) { to[i] = N::from_raw(raw); };
}

}  // namespace fixproof::detail
