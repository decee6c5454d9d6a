/// @file
/// The loops of fixed/batch/batch.hpp and fixed/batch/radian.hpp over whole blocks; see
/// fixed/batch/detail/lanes.hpp.
///
/// Each loop except that of dot returns the number of elements done, and leaves the rest to the
/// caller.

#if defined(FIXED_LANES)
// Loops of many blocks are not inlined, so that their callers are small and therefore fast for
// short spans; but short ones are where the flags promise AVX-512 (all_blocks).
#define FIXED_LANE_LOOP FIXED_LANE_TARGET __attribute__((noinline))

namespace fixproof::detail::FIXED_LANES {

/// The loops as a type, which on_path() passes to its callable.
struct loops {
  /// Whether run() leaves no element if none has a fault: masks fill the last block, and
  /// conversions to float are exact in every rounding mode.
  static constexpr bool fills_spans = has_masks && has_nearest_floats;

  /// Computes the elements from `done` on, up to a block that may have a fault.
  /// @return the number of elements done, with those that were done before
  template <class Operation, class... Places>
  FIXED_ALWAYS_INLINE static std::size_t run(std::size_t done, std::size_t count,
                                             Places... places) noexcept {
    return run_apart<Operation>(done, count, places...);
  }
  /// The same for spans of at most `width` elements, without a call. Does nothing for longer spans,
  /// or if the flags do not promise AVX-512.
  template <class Operation, class... Places>
  FIXED_ALWAYS_INLINE static std::size_t run(few_blocks, std::size_t count,
                                             Places... places) noexcept {
    if constexpr (has_masks && FIXED_SURE_OF_AVX512) {
      if (count <= width) return at_most_two_blocks(Operation{places...}, 0, count);
    }
    return 0;
  }
  /// The same for spans of any length.
  template <class Operation, class... Places>
  FIXED_ALWAYS_INLINE static std::size_t run(all_blocks, std::size_t count,
                                             Places... places) noexcept {
    if constexpr (has_masks && FIXED_SURE_OF_AVX512) {
      const Operation operation{places...};
      return count <= width ? at_most_two_blocks(operation, 0, count)
                            : each_block(operation, 0, count);
    }
    return 0;
  }
  /// Computes the elements from how.done on, and records their faults.
  /// @return as run() above
  template <class Operation, class... Places>
  FIXED_LANE_LOOP static std::size_t run(const recording& how, std::size_t count,
                                         Places... places) noexcept {
    return noted_blocks(Operation{places...}, how.done, count, how.found);
  }

  // Operations for run().
  template <class Number>
  using products = product_blocks<Number, false>;
  template <class Number>
  using mul_adds = product_blocks<Number, true>;
  template <class Number>
  using quotients = quotient_blocks<Number>;
  template <class Raw, int Point>
  using roots = root_blocks<Raw, Point>;
  template <class Number, class Float>
  using from_floats = blocks_from_floats<Number, Float>;
  template <class Number, class Float>
  using to_floats = std::conditional_t<std::is_same_v<Float, double>, to_double_blocks<Number>,
                                       to_float_blocks<Number>>;

  /// run() in a function of its own.
  template <class Operation, class... Places>
  FIXED_LANE_LOOP static std::size_t run_apart(std::size_t done, std::size_t count,
                                               Places... places) noexcept {
    const Operation operation{places...};
    if constexpr (has_masks && !FIXED_SURE_OF_AVX512) {
      if (count - done <= 2 * Operation::size) return at_most_two_blocks(operation, done, count);
    }
    return each_block(operation, done, count);
  }

  /// Returns the sum of the products, modulo 2^64 or exactly.
  template <class Sum, class Number>
  FIXED_ALWAYS_INLINE static Sum dot(const Number* a, const Number* b, std::size_t count) noexcept {
    if constexpr (has_masks && FIXED_SURE_OF_AVX512) {
      if (count <= width) {
        const first_elements some(count);
        dot_sums<Sum> sums;
        sums.add(load<Number>(a, 0, some), load<Number>(b, 0, some));
        Sum sum{};
        sums.add_to(sum);
        return sum;
      }
      if constexpr (std::is_same_v<Sum, std::uint64_t>) return dot_of_blocks<Sum>(a, b, count);
    }
    return long_dot<Sum>(a, b, count);
  }
  template <class Sum, class Number>
  FIXED_LANE_LOOP static Sum long_dot(const Number* a, const Number* b,
                                      std::size_t count) noexcept {
    return dot_of_blocks<Sum>(a, b, count);
  }
  template <class Sum, class Number>
  FIXED_LANE_FUNCTION static Sum dot_of_blocks(const Number* a, const Number* b,
                                               std::size_t count) {
    constexpr bool is_exact = std::is_same_v<Sum, wide_sum>;
    // dot_sums<wide_sum> holds 2^30 products.
    constexpr std::size_t most = is_exact ? std::size_t{1} << 30 : ~std::size_t{0};
    Sum sum{};
    std::size_t i = 0;
    do {
      // Two blocks at a time have four sums, so that no addition waits for the one before it.
      dot_sums<Sum> first;
      dot_sums<Sum> second;
      const std::size_t end = i + (std::min)(count - i, most);
      for (; end - i >= 2 * width; i += 2 * width) {
        first.add(load<Number>(a, i), load<Number>(b, i));
        second.add(load<Number>(a, i + width), load<Number>(b, i + width));
      }
      if (end - i >= width) {
        first.add(load<Number>(a, i), load<Number>(b, i));
        i += width;
      }
      if constexpr (has_masks) {
        if (i < end) {
          const first_elements rest(end - i);
          second.add(load<Number>(a, i, rest), load<Number>(b, i, rest));
          i = end;
        }
      }
      first.add(second);
      first.add_to(sum);
    } while (is_exact && count - i >= (has_masks ? 1 : width));
    if constexpr (!has_masks) {  // masks leave no element
      for (; i < count; ++i) {
        const std::int64_t product = std::int64_t{a[i].raw()} * b[i].raw();
        if constexpr (is_exact) {
          sum.add(product);
        } else {
          sum += static_cast<std::uint64_t>(product);
        }
      }
    }
    return sum;
  }

  /// Does nothing if the lanes are too narrow for sums. References to pointers spare copies of
  /// pointers that were stored one by one, which would wait for those stores.
  template <template <class> class Transform, class Number, class From, class To>
  FIXED_LANE_LOOP static std::size_t transform(const transform_rows<Number>& rows, const From& from,
                                               const To& to, std::size_t count,
                                               fault_recorder& found) noexcept {
    if (!Transform<Number>::sums_fit_lanes(rows)) return 0;
    return transform_blocks<Transform>(rows, from, to, count, found);
  }

  template <class Number, class From, class To>
  FIXED_LANE_LOOP static std::size_t project(Number constant, const From& from, const To& to,
                                             std::size_t count, fault_recorder& found) noexcept {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 x;
      i32 y;
      project_block<Number>(load_vertices<Number>(from, i, whole_block{}), i32{} + constant.raw(),
                            x, y, i, found);
      store_points<Number>(to, i, x, y);
    }
    return i;
  }

  /// The vector form of detail::nearest_sine().
  template <class Raw, int Point>
  FIXED_LANE_LOOP static std::size_t sines(const void* angles, void* results, std::size_t count,
                                           std::uint64_t ahead) noexcept {
    return of_few_or_many<sine_blocks, Raw, Point>(count, angles, results, ahead);
  }

  /// The same for cosines and sines.
  template <class Raw, int Point>
  FIXED_LANE_LOOP static std::size_t sines_and_cosines(const void* angles, void* cosines,
                                                       void* sines, std::size_t count) noexcept {
    return of_few_or_many<sine_cosine_blocks, Raw, Point>(count, angles, cosines, sines);
  }

 private:
  template <template <class, int, bool, template <class, int> class> class Blocks, class Raw,
            int Point, class... Places>
  FIXED_LANE_FUNCTION static std::size_t of_few_or_many(std::size_t count, Places... places) {
    if constexpr (has_masks) {
      // Half a block takes half the products of a block.
      if (count <= width / 2) {
        const Blocks<Raw, Point, true, half_block_of_angles> few{places...};
        return clean_block(few, 0, first_elements(count)) ? count : 0;
      }
      if (count <= width) {
        const Blocks<Raw, Point, true, block_of_angles> few{places...};
        return clean_block(few, 0, first_elements(count)) ? count : 0;
      }
    }
    return of_many<Blocks<Raw, Point, false, block_of_angles>>(count, places...);
  }
  template <class Operation, class... Places>
  FIXED_LANE_LOOP static std::size_t of_many(std::size_t count, Places... places) noexcept {
    return each_block(Operation{places...}, 0, count);
  }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
