/// \file
/// The loops of batch/batch.hpp and batch/radian.hpp over whole blocks; see
/// batch/detail/lanes.hpp.
///
/// Each returns the number of elements done and leaves the last few to the caller. Loops that need
/// exact doubles do nothing if detail::hardware_double is false.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// The loops as a type, which on_path() passes to its callable.
struct loops {
  template <class N>
  FIXED_LANE_TARGET static std::size_t multiply(const void* a, const void* b, void* out,
                                                std::size_t count, fault_recorder& found) {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 bad{};
      store<typename N::raw_type>(
          out, i,
          product<N>(load<typename N::raw_type>(a, i), load<typename N::raw_type>(b, i), bad));
      note_overflows<N::rules.product_range()>(bad, i, found);
    }
    return i;
  }

  template <class N>
  FIXED_LANE_TARGET static std::size_t mul_add(const void* a, const void* b, const void* c,
                                               void* out, std::size_t count,
                                               fault_recorder& found) {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 bad{};
      store<typename N::raw_type>(
          out, i,
          product_and_sum<N>(load<typename N::raw_type>(a, i), load<typename N::raw_type>(b, i),
                             load<typename N::raw_type>(c, i), bad));
      note_overflows<N::rules.product_range()>(bad, i, found);
    }
    return i;
  }

  template <class N>
  FIXED_LANE_TARGET static std::size_t divide(const void* n, const void* d, void* out,
                                              std::size_t count, fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    constexpr std::size_t half = width / 2;
    std::size_t i = 0;
    for (; count - i >= half; i += half) {
      std::uint32_t errors = 0;
      std::uint32_t overflows = 0;
      const divisor_lanes divisor = divisor_of<N>(load_half<typename N::raw_type>(d, i));
      store_half<typename N::raw_type>(
          out, i, quotient<N>(load_half<typename N::raw_type>(n, i), divisor, errors, overflows));
      if (errors != 0) [[unlikely]] {
        found.note_bits(fault::divide_error, errors, i);
      }
      if (overflows != 0) [[unlikely]] {
        found.note_bits(fault::overflow, overflows, i);
      }
    }
    return i;
  }

  template <class Raw, int F>
  FIXED_LANE_TARGET static std::size_t sqrt(const void* x, void* out, std::size_t count,
                                            fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    constexpr std::size_t half = width / 2;
    std::size_t i = 0;
    for (; count - i >= half; i += half) {
      std::uint32_t errors = 0;
      store_half<Raw>(out, i, nearest_roots<F>(load_half<Raw>(x, i), errors));
      if (errors != 0) [[unlikely]] {
        found.note_bits(fault::domain_error, errors, i);
      }
    }
    return i;
  }

  /// Adds the products to `sum` modulo 2^64.
  template <class Raw>
  FIXED_LANE_TARGET static std::size_t dot(const void* a, const void* b, std::size_t count,
                                           std::uint64_t& sum) {
    u64 sums{};
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      const i32 x = load<Raw>(a, i);
      const i32 y = load<Raw>(b, i);
      sums += u64(mul_even(i64(x), i64(y))) + u64(mul_even(odd_lanes(x), odd_lanes(y)));
    }
    for (std::size_t lane = 0; lane < width / 2; ++lane) sum += sums[lane];
    return i;
  }

  /// Adds the products to `sum` exactly. Adds 2^63 to make each product non-negative, and sums its
  /// two halves separately. \pre count <= 2^30
  template <class Raw>
  FIXED_LANE_TARGET static std::size_t dot(const void* a, const void* b, std::size_t count,
                                           wide_sum& sum) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    u64 low{};
    u64 high{};
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      const i32 x = load<Raw>(a, i);
      const i32 y = load<Raw>(b, i);
      const u64 even = u64(mul_even(i64(x), i64(y))) ^ sign;
      const u64 odd = u64(mul_even(odd_lanes(x), odd_lanes(y))) ^ sign;
      low += (even & 0xffffffff) + (odd & 0xffffffff);
      high += (even >> 32) + (odd >> 32);
    }
    const std::uint64_t added_to_each = (i / (width / 2)) << 31;
    for (std::size_t lane = 0; lane < width / 2; ++lane) {
      sum.add(static_cast<std::int64_t>(low[lane]));
      sum.add_shifted_32(static_cast<std::int64_t>(high[lane] - added_to_each));
    }
    return i;
  }

  template <class N>
  FIXED_LANE_TARGET static std::size_t transform(const raw_transform<typename N::raw_type>& by,
                                                 const void* in, void* out, std::size_t count,
                                                 fault_recorder& found) {
    return transform_blocks<N>(by, interleaved_vertices<typename N::raw_type>{in, out}, count,
                               found);
  }

  template <class N>
  FIXED_LANE_TARGET static std::size_t transform(const raw_transform<typename N::raw_type>& by,
                                                 const std::array<const void*, 3>& in,
                                                 const std::array<void*, 3>& out, std::size_t count,
                                                 fault_recorder& found) {
    return transform_blocks<N>(by, vertex_columns<typename N::raw_type>{in, out}, count, found);
  }

  template <class N>
  FIXED_LANE_TARGET static std::size_t project(std::int32_t constant, const void* in, void* out,
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
  FIXED_LANE_TARGET static std::size_t project(std::int32_t constant,
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
  FIXED_LANE_TARGET static std::size_t sines(const void* angles, void* results, std::size_t count,
                                             std::uint64_t ahead) {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      const i32 raw = load<Raw>(angles, i);
      bool doubtful = false;
      i32 result = sines_of<F>(turns_of<F>(raw, ahead), doubtful);
      if (doubtful) [[unlikely]] {
        result = nearest_sines<F>(raw, ahead);
      }
      store<Raw>(results, i, result);
    }
    return i;
  }

  /// As sines(), for cosines and sines.
  template <class Raw, int F>
  FIXED_LANE_TARGET static std::size_t sines_and_cosines(const void* angles, void* cosines,
                                                         void* sines, std::size_t count) {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      const i32 raw = load<Raw>(angles, i);
      const turn_lanes turns = turns_of<F>(raw, 0);
      bool doubtful = false;
      i32 sine = sines_of<F>(turns, doubtful);
      i32 cosine = sines_of<F>({turns.even + quarter_turn, turns.odd + quarter_turn}, doubtful);
      if (doubtful) [[unlikely]] {
        sine = nearest_sines<F>(raw, 0);
        cosine = nearest_sines<F>(raw, quarter_turn);
      }
      store<Raw>(sines, i, sine);
      store<Raw>(cosines, i, cosine);
    }
    return i;
  }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
