/// @file
/// Runs an operation over a span in blocks; see fixed/batch/detail/lanes.hpp.
///
/// An operation of fixed/batch/detail/elements.hpp, fixed/batch/detail/conversion_lanes.hpp or
/// fixed/batch/detail/radian_lanes.hpp has
///
///     using number;                             // what it stores, for store()
///     using check;                              // collects what is_clean() tests
///     static constexpr std::size_t size;        // elements of a block
///     static constexpr bool in_groups;          // whether four blocks at a time are faster
///     out                                       // where results go, for store()
///     results at(std::size_t i, part, check&) const;  // of the elements from i on
///     static bool is_clean(check);              // whether all results are right and have no fault
///     void note(std::size_t i, part, fault_recorder&) const;  // computes, stores, records faults
///
/// An operation that divides also has zeros() and, for four blocks, have_zero(). One of them is
/// asked before at(), so that no lane divides by zero. An operation whose output is never an input
/// has stores_first. It stores before it asks is_clean():
///
///     std::uint32_t zeros(std::size_t i, part) const;  // a bit for each zero divisor
///     bool have_zero(std::size_t i) const;
///     static constexpr bool stores_first;              // true
///
/// An operation may return from half() one for spans of at most half a block, which has number,
/// check, out, at() and is_clean():
///
///     half() const
///
/// An operation whose check is no_faults has no note(). An operation that may be inexact in some
/// rounding mode of the processor also has
///
///     static bool is_exact();
///
/// Most spans have no fault. So the loops keep no report, and stop before the first blocks that may
/// have one. noted_blocks() computes those again and records their faults. Only the loops of sines
/// call a function; the others need no stack.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// Whether no divisor of a block is zero.
template <class Operation, class Part>
FIXED_LANE_FUNCTION bool has_no_zeros(const Operation& operation, std::size_t i, Part part) {
  if constexpr (requires { operation.zeros(i, part); }) return operation.zeros(i, part) == 0;
  return true;
}

/// Computes a block, and stores it unless it may have a fault. noted_blocks() computes such a block
/// again, and needs its operands: an output may be an input.
/// @return whether the block is stored
template <class Operation, class Part>
FIXED_LANE_FUNCTION bool clean_block(const Operation& operation, std::size_t i, Part part) {
  if (!has_no_zeros(operation, i, part)) [[unlikely]] {
    return false;
  }
  typename Operation::check seen{};
  const auto results = operation.at(i, part, seen);
  if (!Operation::is_clean(seen)) [[unlikely]] {
    return false;
  }
  store<typename Operation::number>(operation.out, i, results, part);
  return true;
}

/// Computes the elements from `i` on, which are at most those of two blocks, with few jumps.
/// @return the first element that is left, or `count`
/// @pre has_masks
template <class Operation>
FIXED_LANE_FUNCTION std::size_t at_most_two_blocks(const Operation& operation, std::size_t i,
                                                   std::size_t count) {
  constexpr std::size_t size = Operation::size;
  const std::size_t left = count - i;
  if constexpr (requires { operation.half(); }) {
    if (left <= width / 2)
      return clean_block(operation.half(), i, first_elements(left)) ? count : i;
  }
  if (left <= size) return clean_block(operation, i, first_elements(left)) ? count : i;
  if (!clean_block(operation, i, whole_block{})) return i;
  return clean_block(operation, i + size, first_elements(left - size)) ? count : i + size;
}

/// Computes four blocks and stores them at once.
template <class Operation>
FIXED_LANE_FUNCTION void stored_blocks(const Operation& operation, std::size_t i,
                                       typename Operation::check& seen) {
  using number = typename Operation::number;
  constexpr std::size_t size = Operation::size;
  const auto first = operation.at(i, whole_block{}, seen);
  const auto second = operation.at(i + size, whole_block{}, seen);
  const auto third = operation.at(i + 2 * size, whole_block{}, seen);
  const auto fourth = operation.at(i + 3 * size, whole_block{}, seen);
  store<number>(operation.out, i, first);
  store<number>(operation.out, i + size, second);
  store<number>(operation.out, i + 2 * size, third);
  store<number>(operation.out, i + 3 * size, fourth);
}

/// Computes groups of blocks from `i` on, while they end at or before `end`. Moves `i` behind the
/// last group that has no fault. A group that may have one is stored only if the operation has
/// stores_first.
/// @return false if a group may have a fault; it begins at `i`
template <class Operation>
FIXED_LANE_FUNCTION bool clean_groups(const Operation& operation, std::size_t& i, std::size_t end) {
  using number = typename Operation::number;
  constexpr std::size_t size = Operation::size;
  if constexpr (requires { Operation::stores_first; }) {
    static_assert(size == width || size == width / 2);
    // Four registers: a test takes as long as half of one.
    for (; end - i >= 4 * width; i += 4 * width) {
      typename Operation::check seen{};
      stored_blocks(operation, i, seen);
      if constexpr (size < width) stored_blocks(operation, i + 4 * size, seen);
      if (!Operation::is_clean(seen)) [[unlikely]] {
        return false;
      }
    }
  } else if constexpr (Operation::in_groups) {
    for (; end - i >= 4 * size; i += 4 * size) {
      if constexpr (requires { operation.zeros(i, whole_block{}); }) {
        if (operation.have_zero(i)) [[unlikely]] {
          return false;
        }
      }
      typename Operation::check seen{};
      const auto first = operation.at(i, whole_block{}, seen);
      const auto second = operation.at(i + size, whole_block{}, seen);
      const auto third = operation.at(i + 2 * size, whole_block{}, seen);
      const auto fourth = operation.at(i + 3 * size, whole_block{}, seen);
      if (!Operation::is_clean(seen)) [[unlikely]] {
        return false;
      }
      store<number>(operation.out, i, first);
      store<number>(operation.out, i + size, second);
      store<number>(operation.out, i + 2 * size, third);
      store<number>(operation.out, i + 3 * size, fourth);
    }
  }
  return true;
}

/// Computes whole blocks from `i` on, up to the last that ends at or before `end`, or up to one
/// that may have a fault.
/// @return the first element that is left
template <class Operation>
FIXED_LANE_FUNCTION std::size_t clean_singles(const Operation& operation, std::size_t i,
                                              std::size_t end) {
  constexpr std::size_t size = Operation::size;
  end -= (end - i) % size;
  for (; i != end; i += size) {
    if (!clean_block(operation, i, whole_block{})) [[unlikely]] {
      return i;
    }
  }
  return i;
}

/// Computes groups of blocks, then single ones. With masks, each_block() does the same, because it
/// returns after whole groups.
/// @return the first element that is left. If a whole block before `end` is left, one of the next
/// four registers may have a fault.
template <class Operation>
FIXED_LANE_FUNCTION std::size_t clean_blocks(const Operation& operation, std::size_t i,
                                             std::size_t end) {
  if (!clean_groups(operation, i, end) || i == end) return i;
  return clean_singles(operation, i, end);
}

/// Computes the elements from `i` on.
/// @return the first element that is left, or `count`. Elements are left if their blocks may have a
/// fault, if they do not fill a block and there are no masks, or if they would not be exact.
template <class Operation>
FIXED_LANE_FUNCTION std::size_t each_block(const Operation& operation, std::size_t i,
                                           std::size_t count) {
  constexpr std::size_t size = Operation::size;
  if constexpr (requires { Operation::is_exact(); }) {
    if (!Operation::is_exact()) return i;
  }
  if constexpr (has_masks) {
    if (!clean_groups(operation, i, count)) return i;
    // A span of whole groups ends here. On the way through the rest, each jump takes about a cycle.
    if (i == count) return count;
    i = clean_singles(operation, i, count);
    const std::size_t rest = count - i;
    if (rest == 0) return count;
    if (rest >= size) [[unlikely]] {
      return i;
    }
    return clean_block(operation, i, first_elements(rest)) ? count : i;
  } else {
    if (count - i < size) return i;
    // The last block may overlap the one before it, and an output may be an input. So the last
    // block is computed first.
    const std::size_t last = count - size;
    const std::size_t end = i + (count - i - 1) / size * size;
    if (!has_no_zeros(operation, last, whole_block{})) [[unlikely]] {
      return clean_blocks(operation, i, end);
    }
    typename Operation::check seen{};
    const auto results = operation.at(last, whole_block{}, seen);
    i = clean_blocks(operation, i, end);
    if (i != end || !Operation::is_clean(seen)) return i;
    store<typename Operation::number>(operation.out, last, results, whole_block{});
    return count;
  }
}

/// Computes the elements from `i` on, and records their faults. Calls note() for four blocks, then
/// each_block() until a block may have a fault, and so on. Where faults are frequent, calls note()
/// for 8 or 16 blocks at a time.
/// @return the first element that is left, or `count`. Elements are left if they do not fill a
/// block and there are no masks.
template <class Operation>
FIXED_LANE_FUNCTION std::size_t noted_blocks(const Operation& operation, std::size_t i,
                                             std::size_t count, fault_recorder& found) {
  constexpr std::size_t size = Operation::size;
  std::size_t blocks = 4;
  while (count - i >= (has_masks ? 1 : size)) {
    for (std::size_t k = 0; k < blocks && count - i >= size; ++k, i += size) {
      operation.note(i, whole_block{}, found);
    }
    if constexpr (has_masks) {
      if (count - i < size) {
        operation.note(i, first_elements(count - i), found);
        return count;
      }
    }
    const std::size_t next = each_block(operation, i, count);
    // Where faults are frequent, each_block() mostly stops at once, so it is tried less often.
    blocks = next == i ? (std::min)(2 * blocks, std::size_t{16}) : 4;
    i = next;
  }
  return i;
}

}  // namespace fixproof::detail::FIXED_LANES
#endif
