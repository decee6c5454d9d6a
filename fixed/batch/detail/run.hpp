/// @file
/// The options of a batch, and how it runs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "fixed/batch/detail/element.hpp"
#include "fixed/batch/detail/portable.hpp"
#include "fixed/batch/detail/report.hpp"
#include "fixed/batch/detail/spans.hpp"
#include "fixed/batch/detail/targets.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/policy.hpp"

namespace fixproof::batch {

/// Options of a batch operation.
struct options {
  /// The path to use; path::portable replaces one that the processor lacks.
  path use = path::fastest;
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

/// Computes elements and records their faults. Calls `blocks` on the path of `how`, then `rest`.
/// @tparam few      up to this many elements are faster without that path
/// @tparam has      whether the loops cover the operation
/// @tparam Overflow the overflow rule of the operation
/// @tparam Fault    the divide errors of the operation
/// @param done      the number of elements that are done already
/// @param blocks    (loops, const recording&) -> number of elements done
/// @param rest      (number of elements done, fault_recorder&), computes the others
/// @param operation the name in the text of an error
template <std::size_t few, bool has, overflow Overflow, divide_fault Fault, class Blocks,
          class Rest>
FIXED_ALWAYS_INLINE batch::report run_recorded(const char* operation, const batch::options& how,
                                               std::size_t done, std::size_t count,
                                               const Blocks& blocks, const Rest& rest) {
  fault_recorder found(how.marks.empty() ? how.marks : how.marks.first(count));
  if (count - done > few) {
    const recording from{done, found};
    done = (std::max)(
        done, on_path<has>(how.use, [&](auto on) FIXED_INLINE { return blocks(on, from); }));
  }
  if (done < count) rest(done, found);
  return found.template finish<Overflow, Fault>(operation);
}

/// Calls a lambda, and is never inlined. A local variable that the lambda captures by reference is
/// kept in memory even where the caller does not get here, so the lambda should capture copies.
template <class Call>
FIXED_NOINLINE auto apart(const Call& call) {
  return call();
}

/// Clears the marks, and returns the report of a batch without faults.
FIXED_ALWAYS_INLINE batch::report clean_report(const batch::options& how, std::size_t count) {
  if (!how.marks.empty()) std::fill_n(how.marks.begin(), count, false);
  return {};
}

/// Keeps a copy in memory, from where compilers load it after a call. Otherwise they keep it in a
/// register that the function saves when it starts, even if it makes no call.
template <class Type>
FIXED_ALWAYS_INLINE void keep_in_memory([[maybe_unused]] Type& copy) noexcept {
#if defined(__GNUC__)
  asm("" : "+m"(copy));
#endif
}

/// Calls `Blocks` on a path, from a function of its own: so short spans need no stack, and this one
/// jumps to the loop. The path is last, because the loop takes the other arguments in this order.
template <bool has, class Blocks, class... Places>
FIXED_NOINLINE std::size_t on_chosen_path(std::size_t count, Places... places,
                                          batch::path use) noexcept {
  return on_path<has>(
      use, [=](auto on) FIXED_INLINE { return Blocks{}(on, std::size_t{0}, count, places...); });
}

/// The same on the fastest path, without asking which one.
template <bool has, class Blocks, class... Places>
FIXED_NOINLINE std::size_t on_fastest_path(std::size_t count, Places... places) noexcept {
  return on_path<has>(batch::path::fastest, [=](auto on) FIXED_INLINE {
    return Blocks{}(on, std::size_t{0}, count, places...);
  });
}

/// Computes elements up to the first one that may have a fault.
/// @param element as for each_element(). It may have a member quick(), which returns a result as a
///                word of 64 bits, or one out of range if there may be a fault.
/// @return the number of elements that are done
/// @pre count > 0
template <class Element, class Type, class... From>
FIXED_ALWAYS_INLINE std::size_t few_elements(std::size_t count, const Element& element, Type* to,
                                             const From*... from) {
  std::size_t done = 0;
  if constexpr (requires { element.quick(done, from...); }) {
    using raw = typename Type::raw_type;
    // Words in range have no bits above those of a stored integer once its least value is zero.
    constexpr int places = std::numeric_limits<raw>::digits;
    std::uint64_t all = 0;
    do {
      const std::int64_t word = element.quick(done, from...);
      to[done] = Type::from_raw(static_cast<raw>(word));
      all |= static_cast<std::uint64_t>(word) + (std::uint64_t{1} << places);
    } while (++done != count);
    return all >> (places + 1) == 0 ? count : 0;
  } else {
    do {
      const auto one = element(done, from...);
      if (one.what != fault::none) break;
      to[done] = stored<Type>(one.raw);
    } while (++done != count);
    return done;
  }
}

/// Computes elements that have no faults: blocks in the loops On, unless On is void, and the others
/// one by one.
template <class On, class Blocks, class Element, class Type, class... From>
FIXED_NOINLINE void elements_in(std::size_t count, Type* to, const From*... from) noexcept {
  if constexpr ((... && !std::is_same_v<Type, From>)) {
    // Elements of other types share no memory with the results.
    Type* __restrict const apart_from = to;
    to = apart_from;
  }
  std::size_t i = 0;
  if constexpr (!std::is_void_v<On>) i = Blocks{}(On{}, i, count, to, from...);
  for (; i < count; ++i) to[i] = stored<Type>(Element{}(i, from...).raw);
}

/// The same on a path, without a stack: it jumps to elements_in(), or to the loop if that leaves no
/// element. The path is last, so that the other arguments stay in their registers.
template <bool has, class Blocks, class Element, class Type, class... From>
FIXED_NOINLINE void elements_on(std::size_t count, Type* to, const From*... from,
                                batch::path use) noexcept {
  on_path<has>(
      use,
      [=](auto on) FIXED_INLINE {
        using On = decltype(on);
        if constexpr (On::fills_spans) {
          Blocks{}(on, std::size_t{0}, count, to, from...);
        } else {
          elements_in<On, Blocks, Element, Type, From...>(count, to, from...);
        }
      },
      [=]()
          FIXED_INLINE { elements_in<void, Blocks, Element, Type, From...>(count, to, from...); });
}

/// Runs a batch of elements that have no faults. Without flags that promise AVX-512, the shortest
/// spans are marked as likely, so that they take no jump.
/// @param blocks  as for run_batch(). With all_blocks, it computes all elements.
/// @param element as for each_element()
template <bool has, class Blocks, class Element, class Type, class... From>
FIXED_ALWAYS_INLINE void run_faultless(batch::path use, std::size_t count, Blocks blocks,
                                       Element element, Type* to, const From*... from) noexcept {
  // Up to this many are faster one by one. The short loops that clang vectorises are no faster than
  // masked blocks.
  constexpr std::size_t few = loops_in_vectors ? 1 : 4;
  if constexpr (has && sure_of_masks) {
    if (use == batch::path::fastest) {
      on_path<has>(
          use, [&](auto on) FIXED_INLINE { return blocks(on, all_blocks{}, count, to, from...); });
      return;
    }
  } else if (count - 1 < few) [[likely]] {  // and not 0
    std::size_t i = 0;
    do {
      to[i] = stored<Type>(element(i, from...).raw);
    } while (++i != count);
    return;
  }
  elements_on<has, Blocks, Element, Type, From...>(count, to, from..., use);
}

/// The arguments of a batch that only faults need.
struct fault_context {
  const char* operation;
  batch::options how;
};

/// Computes the elements from `done` on, and records their faults; see run_batch().
template <bool has, overflow Overflow, divide_fault Fault, class Blocks, class Element, class Type,
          class... From>
FIXED_NOINLINE batch::report other_elements(std::size_t done, std::size_t end, Type* to,
                                            const From*... from, const fault_context& faults) {
  return run_recorded<0, has, Overflow, Fault>(
      faults.operation, faults.how, done, end,
      [=](auto on, const recording& start) { return Blocks{}(on, start, end, to, from...); },
      [=](std::size_t i, fault_recorder& found) {
        each_element(i, end, found, Element{}, to, from...);
      });
}

/// Runs a batch of elements that seldom have faults.
/// @tparam few      up to this many elements are faster one by one, or one element if the first
///                  blocks need no call
/// @tparam First    the blocks that need no call if the flags promise AVX-512: few_blocks, or
///                  all_blocks
/// @param blocks    (loops, start, count, to, from...) -> number of elements done. The start is
///                  few_blocks, all_blocks, the index of an element, or a recording. Without a
///                  recording, stops at a fault.
/// @param element   as for each_element()
template <std::size_t few, bool has, overflow Overflow, divide_fault Fault = divide_fault::none,
          class First = few_blocks, class Blocks, class Element, class Type, class... From>
FIXED_ALWAYS_INLINE batch::report run_batch(const char* operation, const batch::options& how,
                                            std::size_t count, Blocks blocks, Element element,
                                            Type* to, const From*... from) {
  constexpr bool blocks_first = has && sure_of_masks;
  // The report, after other_elements() if some are left.
  const auto finished = [&](std::size_t done) FIXED_INLINE {
    if (done == count) return clean_report(how, count);
    return other_elements<has, Overflow, Fault, Blocks, Element, Type, From...>(
        done, count, to, from..., fault_context{operation, how});
  };
  if (count - 1 < (blocks_first ? (std::min)(few, std::size_t{1}) : few)) {  // and not 0
    return finished(few_elements(count, element, to, from...));
  }
  std::size_t done = 0;
  if constexpr (blocks_first && std::is_same_v<First, all_blocks>) {
    if (how.use == batch::path::fastest) {
      done = on_path<has>(
          how.use, [&](auto on) FIXED_INLINE { return blocks(on, First{}, count, to, from...); });
      return finished(done);
    }
  } else if constexpr (blocks_first) {
    done = on_path<has>(how.use, [&](auto on) FIXED_INLINE {
      return blocks(on, few_blocks{}, count, to, from...);
    });
  }
  if (done == count) return clean_report(how, count);
  // The code after a call uses copies. Only the way to the call stores them in memory.
  const auto others = [&](std::size_t end, auto... kept) FIXED_INLINE {
    (keep_in_memory(end), ..., keep_in_memory(kept));
    if constexpr (sure_of_masks) {
      done = (std::max)(done, on_path<has>(how.use, [&](auto on) FIXED_INLINE {
                          return blocks(on, done, count, to, from...);
                        }));
    } else {
      done = how.use == batch::path::fastest
                 ? on_fastest_path<has, Blocks, Type*, const From*...>(count, to, from...)
                 : on_chosen_path<has, Blocks, Type*, const From*...>(count, to, from..., how.use);
    }
    if (done == end) return clean_report(how, end);
    return other_elements<has, Overflow, Fault, Blocks, Element, Type, From...>(
        done, end, kept..., fault_context{operation, how});
  };
  return others(count, to, from...);
}

/// Runs a batch of products, which have no faults unless the policy reports overflows.
template <bool has, class Blocks, class Element, class Number, class... From>
FIXED_ALWAYS_INLINE batch::report run_products(const char* operation, const batch::options& how,
                                               std::size_t count, Blocks blocks, Element element,
                                               Number* to, const From*... from) {
  constexpr overflow range = Number::rules.product_range();
  if constexpr (range == overflow::wrap) {
    run_faultless<has>(how.use, count, blocks, element, to, from...);
    return clean_report(how, count);
  } else {
    // clang tests the range of each product in a branch. g++ 12 saves registers before it knows
    // that a span is short.
    using first = std::conditional_t<loops_in_vectors, all_blocks, few_blocks>;
    constexpr std::size_t few = loops_in_vectors ? 2 : 4;
    return run_batch<few, has, range, divide_fault::none, first>(operation, how, count, blocks,
                                                                 element, to, from...);
  }
}

}  // namespace fixproof::detail
