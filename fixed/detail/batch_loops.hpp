/// \file
/// The loops of fixed/batch.hpp and fixed/batch_radian.hpp over whole blocks; see
/// fixed/detail/batch_lanes.hpp.
///
/// Each returns how many elements it has done: the last few are left to the caller. Where doubles
/// are not what they should be (detail::hardware_double), those that need them do nothing.

#if defined(FIXED_LANES)
namespace fixed::detail::FIXED_LANES {

/// \name Numbers x y z x y z ... and x y x y ..., from and to blocks of each
/// \{

struct block_of_vertices {
  i32 x, y, z;
};

/// The lanes of the i-th register of three in which there is component c, as bits.
constexpr unsigned lanes_of(std::size_t c, std::size_t i) {
  unsigned lanes = 0;
  for (std::size_t lane = 0; lane < width; ++lane) {
    if ((width * i + lane) % 3 == c) lanes |= 1U << lane;
  }
  return lanes;
}

/// The lane in which component c of vertex k is, in whichever register. The width is no multiple of
/// three: no two vertices share one.
constexpr std::size_t lane_of(std::size_t c, std::size_t k) { return (3 * k + c) % width; }

/// What permute() wants to bring component c to the lane of its vertex, and back.
template <std::size_t c>
inline constexpr lane_array to_vertices = [] {
  lane_array from{};
  for (std::size_t k = 0; k < width; ++k) from[k] = static_cast<std::int32_t>(lane_of(c, k));
  return from;
}();
template <std::size_t c>
inline constexpr lane_array from_vertices = [] {
  lane_array from{};
  for (std::size_t k = 0; k < width; ++k) from[lane_of(c, k)] = static_cast<std::int32_t>(k);
  return from;
}();

/// The same for points, whose lanes come in pairs.
template <std::size_t i>
inline constexpr lane_array from_points = [] {
  lane_array from{};
  for (std::size_t lane = 0; lane < width; ++lane) {
    from[lane] = static_cast<std::int32_t>((width * i + lane) / 2);
  }
  return from;
}();

template <std::size_t c>
FIXED_LANE_FUNCTION i32 component(i32 first, i32 second, i32 third) {
  return permute(blend<lanes_of(c, 2)>(blend<lanes_of(c, 1)>(first, second), third),
                 lanes(to_vertices<c>));
}

/// Asks for what is read eight blocks of AVX-512 later: in one stream of three registers a block
/// the processor does not look ahead far enough by itself. An address beyond the end is no access.
/// \param index  of the next byte that is read
/// \tparam block bytes that are read before this is called again
template <std::size_t block>
FIXED_LANE_FUNCTION void ask_ahead(const void* base, std::size_t index) {
  constexpr std::uintptr_t distance = 1536;
  const auto at = reinterpret_cast<std::uintptr_t>(base) + index + distance;
  for (std::uintptr_t line = 0; line < block; line += 64) {
    __builtin_prefetch(reinterpret_cast<const void*>(at + line));
  }
}

/// Vertices index, index + 1, ...
template <int F>
FIXED_LANE_FUNCTION block_of_vertices load_vertices(const void* base, std::size_t index) {
  constexpr std::size_t vertex = 3 * sizeof(raw_t<F>);
  ask_ahead<vertex * width>(base, vertex * index);
  const i32 first = load<F>(base, 3 * index);
  const i32 second = load<F>(base, 3 * index + width);
  const i32 third = load<F>(base, 3 * index + 2 * width);
  return {component<0>(first, second, third), component<1>(first, second, third),
          component<2>(first, second, third)};
}

template <int F>
FIXED_LANE_FUNCTION void store_vertices(void* base, std::size_t index, const block_of_vertices& v) {
  const i32 x = permute(v.x, lanes(from_vertices<0>));
  const i32 y = permute(v.y, lanes(from_vertices<1>));
  const i32 z = permute(v.z, lanes(from_vertices<2>));
  store<F>(base, 3 * index, blend<lanes_of(2, 0)>(blend<lanes_of(1, 0)>(x, y), z));
  store<F>(base, 3 * index + width, blend<lanes_of(2, 1)>(blend<lanes_of(1, 1)>(x, y), z));
  store<F>(base, 3 * index + 2 * width, blend<lanes_of(2, 2)>(blend<lanes_of(1, 2)>(x, y), z));
}

template <int F>
FIXED_LANE_FUNCTION void store_points(void* base, std::size_t index, i32 x, i32 y) {
  const i32 low = lanes(from_points<0>);
  const i32 high = lanes(from_points<1>);
  constexpr unsigned odds = 0xaaaa;
  store<F>(base, 2 * index, blend<odds>(permute(x, low), permute(y, low)));
  store<F>(base, 2 * index + width, blend<odds>(permute(x, high), permute(y, high)));
}

/// \}

/// The coefficients of a transform, each in every lane.
struct broadcast_transform {
  i32 rows[3][4];
};

template <int F>
FIXED_LANE_FUNCTION broadcast_transform broadcast(const raw_transform<F>& transform) {
  broadcast_transform result;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      result.rows[i][k] = i32{} + std::int32_t{transform[i][k]};
    }
  }
  return result;
}

template <int F, policy P>
FIXED_LANE_FUNCTION i32 coordinate(const i32 (&row)[4], const block_of_vertices& v, i32& bad) {
  i32 sum = product<F, P>(row[0], v.x, bad);
  sum = added<F, P>(sum, product<F, P>(row[1], v.y, bad), bad);
  sum = added<F, P>(sum, product<F, P>(row[2], v.z, bad), bad);
  return added<F, P>(sum, row[3], bad);
}

template <int F, policy P>
FIXED_LANE_FUNCTION block_of_vertices transformed_block(const broadcast_transform& t,
                                                        const block_of_vertices& v, i32& bad) {
  return {coordinate<F, P>(t.rows[0], v, bad), coordinate<F, P>(t.rows[1], v, bad),
          coordinate<F, P>(t.rows[2], v, bad)};
}

/// x and y over z, times a constant.
template <int F, policy P>
FIXED_LANE_FUNCTION void project_block(const block_of_vertices& v, i32 constant, i32& x, i32& y,
                                       std::size_t index, fault_recorder& found) {
  const divisor_lanes low = divisor_of<F, P>(lower(v.z));
  const divisor_lanes high = divisor_of<F, P>(upper(v.z));
  std::uint32_t errors[4];
  std::uint32_t overflows[4];
  x = join(quotient<F, P>(lower(v.x), low, errors[0], overflows[0]),
           quotient<F, P>(upper(v.x), high, errors[1], overflows[1]));
  y = join(quotient<F, P>(lower(v.y), low, errors[2], overflows[2]),
           quotient<F, P>(upper(v.y), high, errors[3], overflows[3]));
  i32 bad{};
  x = product<F, P>(x, constant, bad);
  y = product<F, P>(y, constant, bad);
  const std::uint32_t no_quotient = errors[0] | errors[2] | (errors[1] | errors[3]) << (width / 2);
  if (no_quotient != 0) [[unlikely]] {
    found.note_bits(fault::divide_error, no_quotient, index);
  }
  if constexpr (P.range != overflow::wrap) {
    const std::uint32_t out =
        (overflows[0] | overflows[2] | (overflows[1] | overflows[3]) << (width / 2) | bits(bad)) &
        ~no_quotient;
    if (out != 0) [[unlikely]] {
      found.note_bits(fault::overflow, out, index);
    }
  }
}

/// Notes where a lane of `bad` is set. Nothing is, under overflow::wrap.
template <policy P>
FIXED_LANE_FUNCTION void note_overflows(i32 bad, std::size_t index, fault_recorder& found) {
  if constexpr (P.range != overflow::wrap) {
    const std::uint32_t out = bits(bad);
    if (out != 0) [[unlikely]] {
      found.note_bits(fault::overflow, out, index);
    }
  }
}

/// The loops, as a type: what on_path() hands over.
struct loops {
  template <int F, policy P>
  FIXED_LANE_TARGET static std::size_t multiply(const void* a, const void* b, void* out,
                                                std::size_t count, fault_recorder& found) {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 bad{};
      store<F>(out, i, product<F, P>(load<F>(a, i), load<F>(b, i), bad));
      note_overflows<P>(bad, i, found);
    }
    return i;
  }

  template <int F, policy P>
  FIXED_LANE_TARGET static std::size_t mul_add(const void* a, const void* b, const void* c,
                                               void* out, std::size_t count,
                                               fault_recorder& found) {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 bad{};
      store<F>(out, i, product_and_sum<F, P>(load<F>(a, i), load<F>(b, i), load<F>(c, i), bad));
      note_overflows<P>(bad, i, found);
    }
    return i;
  }

  template <int F, policy P>
  FIXED_LANE_TARGET static std::size_t divide(const void* n, const void* d, void* out,
                                              std::size_t count, fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    constexpr std::size_t half = width / 2;
    std::size_t i = 0;
    for (; count - i >= half; i += half) {
      std::uint32_t errors = 0;
      std::uint32_t overflows = 0;
      const divisor_lanes divisor = divisor_of<F, P>(load_half<F>(d, i));
      store_half<F>(out, i, quotient<F, P>(load_half<F>(n, i), divisor, errors, overflows));
      if (errors != 0) [[unlikely]] {
        found.note_bits(fault::divide_error, errors, i);
      }
      if (overflows != 0) [[unlikely]] {
        found.note_bits(fault::overflow, overflows, i);
      }
    }
    return i;
  }

  template <int F>
  FIXED_LANE_TARGET static std::size_t sqrt(const void* x, void* out, std::size_t count,
                                            fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    constexpr std::size_t half = width / 2;
    std::size_t i = 0;
    for (; count - i >= half; i += half) {
      std::uint32_t errors = 0;
      store_half<F>(out, i, nearest_root<F>(load_half<F>(x, i), errors));
      if (errors != 0) [[unlikely]] {
        found.note_bits(fault::domain_error, errors, i);
      }
    }
    return i;
  }

  /// Adds the products to `sum` modulo 2^64.
  template <int F>
  FIXED_LANE_TARGET static std::size_t dot(const void* a, const void* b, std::size_t count,
                                           std::uint64_t& sum) {
    u64 sums{};
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      const i32 x = load<F>(a, i);
      const i32 y = load<F>(b, i);
      sums += u64(mul_even(i64(x), i64(y))) + u64(mul_even(odd_lanes(x), odd_lanes(y)));
    }
    for (std::size_t lane = 0; lane < width / 2; ++lane) sum += sums[lane];
    return i;
  }

  /// Adds the products to `sum`, exactly: the two halves of each, which with 2^63 added is not
  /// negative, in sums of their own. \pre count <= 2^30
  template <int F>
  FIXED_LANE_TARGET static std::size_t dot(const void* a, const void* b, std::size_t count,
                                           wide_sum& sum) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    u64 low{};
    u64 high{};
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      const i32 x = load<F>(a, i);
      const i32 y = load<F>(b, i);
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

  template <int F, policy P>
  FIXED_LANE_TARGET static std::size_t transform(const raw_transform<F>& by, const void* in,
                                                 void* out, std::size_t count,
                                                 fault_recorder& found) {
    const broadcast_transform t = broadcast<F>(by);
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 bad{};
      store_vertices<F>(out, i, transformed_block<F, P>(t, load_vertices<F>(in, i), bad));
      note_overflows<P>(bad, i, found);
    }
    return i;
  }

  template <int F, policy P>
  FIXED_LANE_TARGET static std::size_t transform(const raw_transform<F>& by,
                                                 const std::array<const void*, 3>& in,
                                                 const std::array<void*, 3>& out, std::size_t count,
                                                 fault_recorder& found) {
    const broadcast_transform t = broadcast<F>(by);
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 bad{};
      const block_of_vertices v = transformed_block<F, P>(
          t, {load<F>(in[0], i), load<F>(in[1], i), load<F>(in[2], i)}, bad);
      store<F>(out[0], i, v.x);
      store<F>(out[1], i, v.y);
      store<F>(out[2], i, v.z);
      note_overflows<P>(bad, i, found);
    }
    return i;
  }

  template <int F, policy P>
  FIXED_LANE_TARGET static std::size_t project(std::int32_t constant, const void* in, void* out,
                                               std::size_t count, fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 x;
      i32 y;
      project_block<F, P>(load_vertices<F>(in, i), i32{} + constant, x, y, i, found);
      store_points<F>(out, i, x, y);
    }
    return i;
  }

  template <int F, policy P>
  FIXED_LANE_TARGET static std::size_t project(std::int32_t constant,
                                               const std::array<const void*, 3>& in,
                                               const std::array<void*, 2>& out, std::size_t count,
                                               fault_recorder& found) {
    if constexpr (!hardware_double) return 0;
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      i32 x;
      i32 y;
      project_block<F, P>({load<F>(in[0], i), load<F>(in[1], i), load<F>(in[2], i)},
                          i32{} + constant, x, y, i, found);
      store<F>(out[0], i, x);
      store<F>(out[1], i, y);
    }
    return i;
  }

  /// detail::nearest_sine().
  template <int F>
  FIXED_LANE_TARGET static std::size_t sines(const void* angles, void* results, std::size_t count,
                                             std::uint64_t ahead) {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      const i32 raw = load<F>(angles, i);
      bool doubtful = false;
      i32 result = sines_of<F>(turns_of<F>(raw, ahead), doubtful);
      if (doubtful) [[unlikely]] {
        result = nearest_sines<F>(raw, ahead);
      }
      store<F>(results, i, result);
    }
    return i;
  }

  /// As sines(), of cosines and sines.
  template <int F>
  FIXED_LANE_TARGET static std::size_t sines_and_cosines(const void* angles, void* cosines,
                                                         void* sines, std::size_t count) {
    std::size_t i = 0;
    for (; count - i >= width; i += width) {
      const i32 raw = load<F>(angles, i);
      const turn_lanes turns = turns_of<F>(raw, 0);
      bool doubtful = false;
      i32 sine = sines_of<F>(turns, doubtful);
      i32 cosine = sines_of<F>({turns.even + quarter_turn, turns.odd + quarter_turn}, doubtful);
      if (doubtful) [[unlikely]] {
        sine = nearest_sines<F>(raw, 0);
        cosine = nearest_sines<F>(raw, quarter_turn);
      }
      store<F>(sines, i, sine);
      store<F>(cosines, i, cosine);
    }
    return i;
  }
};

}  // namespace fixed::detail::FIXED_LANES
#endif
