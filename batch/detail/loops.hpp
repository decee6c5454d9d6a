/// \file
/// The loops of batch/batch.hpp and batch/radian.hpp over whole blocks; see
/// batch/detail/lanes.hpp.
///
/// Each loop returns the number of elements done, and leaves the rest to the caller.

#if defined(FIXED_LANES)
// Loops of many blocks are never inlined, so that their callers are small and therefore fast for
// short spans.
#define FIXED_LANE_LOOP FIXED_LANE_TARGET __attribute__((noinline))

namespace fixproof::detail::FIXED_LANES {

/// The loops as a type, which on_path() passes to its callable.
struct loops {
  /// Computes a span with the operation of these places.
  template <class Operation, class... Places>
  FIXED_ALWAYS_INLINE static std::size_t run(std::size_t count, fault_recorder& found,
                                             Places... places) {
#if FIXED_LANE_BYTES == 64 && FIXED_SURE_OF_AVX512
    // The caller has these instructions, too, so one block needs no call.
    if constexpr (!requires { Operation::is_large; }) {
      if (count <= Operation::size) {
        one_block(Operation{places...}, 0, first_elements(count), found);
        return count;
      }
    }
#endif
    return many<Operation>(count, found, places...);
  }
  template <class Operation, class... Places>
  FIXED_LANE_LOOP static std::size_t many(std::size_t count, fault_recorder& found,
                                          Places... places) {
    return each_block(Operation{places...}, count, found);
  }

  // Operations for run().
  template <class N>
  using products = product_blocks<N>;
  template <class N>
  using mul_adds = mul_add_blocks<N>;
  template <class N>
  using quotients = quotient_blocks<N>;
  template <class Raw, int F>
  using roots = root_blocks<Raw, F>;
  template <class N, class Float>
  using from_floats = from_float_blocks<N, Float>;
  template <class N, class Float>
  using to_floats =
      std::conditional_t<std::is_same_v<Float, double>, to_double_blocks<N>, to_float_blocks<N>>;

  /// Adds the products to `sum`, modulo 2^64 or exactly. \pre For exact sums: count <= 2^30
  template <class Raw, class Sum>
  FIXED_LANE_LOOP static std::size_t dot(const void* a, const void* b, std::size_t count,
                                         Sum& sum) {
    // Two blocks at a time have four sums, so that no addition waits for the one before it.
    dot_sums<Sum> first;
    dot_sums<Sum> second;
    std::size_t i = 0;
    for (; count - i >= 2 * width; i += 2 * width) {
      first.add(load<Raw>(a, i), load<Raw>(b, i));
      second.add(load<Raw>(a, i + width), load<Raw>(b, i + width));
    }
    if (count - i >= width) {
      first.add(load<Raw>(a, i), load<Raw>(b, i));
      i += width;
    }
    if constexpr (has_masks) {
      if (i < count) {
        const first_elements rest(count - i);
        second.add(load<Raw>(a, i, rest), load<Raw>(b, i, rest));
        i = count;
      }
    }
    first.add(second);
    first.add_to(sum);
    return i;
  }

  /// Does nothing if the lanes are too narrow for sums. References to pointers spare copies of
  /// pointers that were stored one by one, which would wait for those stores.
  template <template <class> class Transform, class N, class From, class To>
  FIXED_LANE_LOOP static std::size_t transform(const transform_rows<N>& rows, const From& from,
                                               const To& to, std::size_t count,
                                               fault_recorder& found) {
    if (!Transform<N>::sums_fit_lanes(rows)) return 0;
    return transform_blocks<Transform>(rows, from, to, count, found);
  }

  template <class N, class From, class To>
  FIXED_LANE_LOOP static std::size_t project(N constant, const From& from, const To& to,
                                             std::size_t count, fault_recorder& found) {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 x;
      i32 y;
      project_block<N>(load_vertices<N>(from, i, whole_block{}), i32{} + constant.raw(), x, y, i,
                       found);
      store_points<N>(to, i, x, y);
    }
    return i;
  }

  /// The vector form of detail::nearest_sine().
  template <class Raw, int F>
  FIXED_LANE_LOOP static std::size_t sines(const void* angles, void* results, std::size_t count,
                                           std::uint64_t ahead) {
    fault_recorder none({});
    return each_block(sine_blocks<Raw, F>{angles, results, ahead}, count, none);
  }

  /// The same for cosines and sines.
  template <class Raw, int F>
  FIXED_LANE_LOOP static std::size_t sines_and_cosines(const void* angles, void* cosines,
                                                       void* sines, std::size_t count) {
    fault_recorder none({});
    return each_block(sine_cosine_blocks<Raw, F>{angles, {cosines, sines}}, count, none);
  }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
