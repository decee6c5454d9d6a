/// \file
/// The loops of batch/batch.hpp and batch/radian.hpp over whole blocks; see
/// batch/detail/lanes.hpp.
///
/// Each loop returns the number of elements done, and leaves the rest to the caller. Loops that
/// need exact doubles do nothing if detail::hardware_double is false.

#if defined(FIXED_LANES)
// The loops are never inlined, so that their callers are small and therefore fast for short spans.
#define FIXED_LANE_LOOP FIXED_LANE_TARGET __attribute__((noinline))

namespace fixproof::detail::FIXED_LANES {

/// The loops as a type, which on_path() passes to its callable.
struct loops {
  template <class N>
  FIXED_LANE_LOOP static std::size_t multiply(const void* a, const void* b, void* out,
                                              std::size_t count, fault_recorder& found) {
    return each_block(product_blocks<N>{a, b, out}, count, found);
  }

  template <class N>
  FIXED_LANE_LOOP static std::size_t mul_add(const void* a, const void* b, const void* c, void* out,
                                             std::size_t count, fault_recorder& found) {
    return each_block(mul_add_blocks<N>{a, b, c, out}, count, found);
  }

  template <class N>
  FIXED_LANE_LOOP static std::size_t divide(const void* n, const void* d, void* out,
                                            std::size_t count, fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    return each_block(quotient_blocks<N>{n, d, out}, count, found);
  }

  template <class Raw, int F>
  FIXED_LANE_LOOP static std::size_t sqrt(const void* x, void* out, std::size_t count,
                                          fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    return each_block(root_blocks<Raw, F>{x, out}, count, found);
  }

  template <class N, class Float>
  FIXED_LANE_LOOP static std::size_t from_floats(const void* x, void* out, std::size_t count,
                                                 fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    return each_block(from_float_blocks<N, Float>{x, out}, count, found);
  }

  template <class N, class Float>
  FIXED_LANE_LOOP static std::size_t to_floats(const void* x, void* out, std::size_t count,
                                               fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    if constexpr (std::is_same_v<Float, double>) {
      return each_block(to_double_blocks<N>{x, out}, count, found);
    } else {
      if (!floats_are_nearest()) return 0;
      return each_block(to_float_blocks<N>{x, out}, count, found);
    }
  }

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

  template <class N>
  FIXED_LANE_LOOP static std::size_t transform(const raw_transform<typename N::raw_type>& by,
                                               const void* in, void* out, std::size_t count,
                                               fault_recorder& found) {
    return transform_blocks<N>(by, interleaved_vertices<typename N::raw_type>{in, out}, count,
                               found);
  }

  template <class N>
  FIXED_LANE_LOOP static std::size_t transform(const raw_transform<typename N::raw_type>& by,
                                               const std::array<const void*, 3>& in,
                                               const std::array<void*, 3>& out, std::size_t count,
                                               fault_recorder& found) {
    return transform_blocks<N>(by, vertex_columns<typename N::raw_type>{in, out}, count, found);
  }

  template <class N>
  FIXED_LANE_LOOP static std::size_t project(std::int32_t constant, const void* in, void* out,
                                             std::size_t count, fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 x;
      i32 y;
      project_block<N>(load_vertices<typename N::raw_type>(in, i), i32{} + constant, x, y, i,
                       found);
      store_points<typename N::raw_type>(out, i, x, y);
    }
    return i;
  }

  template <class N>
  FIXED_LANE_LOOP static std::size_t project(std::int32_t constant,
                                             const std::array<const void*, 3>& in,
                                             const std::array<void*, 2>& out, std::size_t count,
                                             fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 x;
      i32 y;
      project_block<N>({load<typename N::raw_type>(in[0], i), load<typename N::raw_type>(in[1], i),
                        load<typename N::raw_type>(in[2], i)},
                       i32{} + constant, x, y, i, found);
      store<typename N::raw_type>(out[0], i, x);
      store<typename N::raw_type>(out[1], i, y);
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
