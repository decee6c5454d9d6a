/// \file
/// Runs an operation over a span in blocks; see batch/detail/lanes.hpp.
///
/// An operation of batch/detail/elements.hpp or batch/detail/conversion_lanes.hpp has
///
///     static constexpr std::size_t size;        // elements of a block
///     results at(std::size_t i, part) const;    // of the elements from i on
///
/// and its results have
///
///     void store(void* out, std::size_t i, part) const;
///     void note(std::size_t i, std::uint32_t of, fault_recorder& found) const;
///
/// `of` has a bit set for each element whose fault is recorded. An operation whose range can be
/// checked for a group of blocks at once also has
///
///     static constexpr bool checks_later = true;
///     i32 at(std::size_t i, u64& sums) const;   // see in_range()
///
/// An operation whose blocks callers should not inline has a member is_large.
///
/// An operation that may be inexact in some rounding mode of the processor also has
///
///     static bool is_exact();
///
/// Results whose member `missing` says which elements note() computes once more are noted in
/// groups.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

template <class Operation, class Part>
FIXED_LANE_FUNCTION void one_block(const Operation& operation, std::size_t i, Part part,
                                   fault_recorder& found) {
  const auto results = operation.at(i, part);
  results.store(operation.out, i, part);
  results.note(i, part.bits, found);
}

/// Computes four blocks at a time, as far as they go. \return the first element that is left
template <class Operation>
FIXED_LANE_FUNCTION std::size_t groups_of_blocks(const Operation& operation, std::size_t end,
                                                 fault_recorder& found) {
  constexpr std::size_t size = Operation::size;
  std::size_t i = 0;
  for (const std::size_t groups = end - end % (4 * size); i != groups; i += 4 * size) {
    const auto first = operation.at(i, whole_block{});
    const auto second = operation.at(i + size, whole_block{});
    const auto third = operation.at(i + 2 * size, whole_block{});
    const auto fourth = operation.at(i + 3 * size, whole_block{});
    first.store(operation.out, i, whole_block{});
    second.store(operation.out, i + size, whole_block{});
    third.store(operation.out, i + 2 * size, whole_block{});
    fourth.store(operation.out, i + 3 * size, whole_block{});
    if ((first.missing | second.missing | third.missing | fourth.missing) != 0) [[unlikely]] {
      first.note(i, ~0U, found);
      second.note(i + size, ~0U, found);
      third.note(i + 2 * size, ~0U, found);
      fourth.note(i + 3 * size, ~0U, found);
    }
  }
  return i;
}

/// Computes the elements below `end`, a multiple of the block size.
template <class Operation>
FIXED_LANE_FUNCTION void whole_blocks(const Operation& operation, std::size_t end,
                                      fault_recorder& found) {
  constexpr std::size_t size = Operation::size;
  std::size_t i = 0;
  if constexpr (Operation::checks_later) {
    using raw = typename Operation::number::raw_type;
    for (const std::size_t groups = end - end % (4 * size); i != groups; i += 4 * size) {
      u64 sums{};
      const i32 first = operation.at(i, sums);
      const i32 second = operation.at(i + size, sums);
      const i32 third = operation.at(i + 2 * size, sums);
      const i32 fourth = operation.at(i + 3 * size, sums);
      if (in_range<typename Operation::number>(sums)) [[likely]] {
        store<raw>(operation.out, i, first);
        store<raw>(operation.out, i + size, second);
        store<raw>(operation.out, i + 2 * size, third);
        store<raw>(operation.out, i + 3 * size, fourth);
      } else {
        for (std::size_t k = i; k != i + 4 * size; k += size) {
          one_block(operation, k, whole_block{}, found);
        }
      }
    }
  }
  if constexpr (requires { operation.at(i, whole_block{}).missing; }) {
    i = groups_of_blocks(operation, end, found);
  }
  for (; i != end; i += size) one_block(operation, i, whole_block{}, found);
}

/// Computes a span.
/// \return the number of elements done: all of them, or none if they would not be exact, or if they
/// do not fill a block and there are no masks
template <class Operation>
FIXED_LANE_FUNCTION std::size_t each_block(const Operation& operation, std::size_t count,
                                           fault_recorder& found) {
  constexpr std::size_t size = Operation::size;
  if constexpr (requires { Operation::is_exact(); }) {
    if (!Operation::is_exact()) return 0;
  }
  if constexpr (has_masks) {
    const std::size_t rest = count % size;
    whole_blocks(operation, count - rest, found);
    if (rest != 0) one_block(operation, count - rest, first_elements(rest), found);
    return count;
  } else {
    if (count < size) return 0;
    // The last block may overlap the one before it, and an output may be an input. So the last
    // block is computed first.
    const std::size_t last = count - size;
    const auto results = operation.at(last, whole_block{});
    const std::size_t end = (count - 1) / size * size;
    whole_blocks(operation, end, found);
    results.store(operation.out, last, whole_block{});
    results.note(last, ~0U << (end - last), found);
    return count;
  }
}

}  // namespace fixproof::detail::FIXED_LANES
#endif
