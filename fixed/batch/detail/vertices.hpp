/// @file
/// Vertices and points in vector registers; see fixed/batch/detail/lanes.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

// Conversion between interleaved (x y z ..., x y ...) and per-coordinate blocks.

struct block_of_vertices {
  i32 x, y, z;
};

/// The lanes that hold component c in register i of three, as bits.
constexpr unsigned lanes_of(std::size_t c, std::size_t i) {
  unsigned lanes = 0;
  for (std::size_t lane = 0; lane < width; ++lane) {
    if ((width * i + lane) % 3 == c) lanes |= 1U << lane;
  }
  return lanes;
}

/// The lane that holds component c of vertex k, in whichever register. The width is not a multiple
/// of three, so no two vertices share a lane.
constexpr std::size_t lane_of(std::size_t c, std::size_t k) { return (3 * k + c) % width; }

/// The permutations that move component c to the lane of its vertex, and back.
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

/// The same for points, whose lanes are in pairs.
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

FIXED_LANE_FUNCTION block_of_vertices vertices_of(i32 first, i32 second, i32 third) {
  return {component<0>(first, second, third), component<1>(first, second, third),
          component<2>(first, second, third)};
}

/// x y z x y z ... in three registers.
struct registers_of_vertices {
  i32 first, second, third;
};

FIXED_LANE_FUNCTION registers_of_vertices registers_of(const block_of_vertices& v) {
  const i32 x = permute(v.x, lanes(from_vertices<0>));
  const i32 y = permute(v.y, lanes(from_vertices<1>));
  const i32 z = permute(v.z, lanes(from_vertices<2>));
  return {blend<lanes_of(2, 0)>(blend<lanes_of(1, 0)>(x, y), z),
          blend<lanes_of(2, 1)>(blend<lanes_of(1, 1)>(x, y), z),
          blend<lanes_of(2, 2)>(blend<lanes_of(1, 2)>(x, y), z)};
}

// Addresses are numbers here: a prefetch may lie beyond the end of an array.
// NOLINTBEGIN(*-reinterpret-cast,performance-no-int-to-ptr)

/// Whether element `index` is aligned to the register size.
template <class Number>
bool is_aligned(const void* base, std::size_t index) {
  return (reinterpret_cast<std::uintptr_t>(base) + index * sizeof(Number)) % FIXED_LANE_BYTES == 0;
}

/// Prefetches the data that is read eight AVX-512 blocks later. In a stream of three registers per
/// block, the hardware prefetcher does not look far enough ahead. An address beyond the end of an
/// array causes no access.
/// @param index  the next byte to read
/// @tparam block the bytes read between two calls
template <std::size_t block>
FIXED_LANE_FUNCTION void prefetch(const void* base, std::size_t index) {
  constexpr std::uintptr_t distance = 1536;
  const auto at = reinterpret_cast<std::uintptr_t>(base) + index + distance;
  for (std::uintptr_t line = 0; line < block; line += 64) {
    __builtin_prefetch(reinterpret_cast<const void*>(at + line));
  }
}

// NOLINTEND(*-reinterpret-cast,performance-no-int-to-ptr)

/// @name Vertices x y z x y z in one array, or each coordinate in its own
/// \{

template <class Number>
FIXED_LANE_FUNCTION block_of_vertices load_vertices(const void* from, std::size_t i, whole_block) {
#if FIXED_LANE_BYTES == 16
  if constexpr (sizeof(Number) == 4) {
    const int32x4x3_t v = vld3q_s32(static_cast<const std::int32_t*>(from) + 3 * i);
    return {i32(v.val[0]), i32(v.val[1]), i32(v.val[2])};
  }
#endif
  prefetch<3 * sizeof(Number) * width>(from, 3 * sizeof(Number) * i);
  const i32 first = load<Number>(from, 3 * i);
  const i32 second = load<Number>(from, 3 * i + width);
  const i32 third = load<Number>(from, 3 * i + 2 * width);
  return vertices_of(first, second, third);
}
template <class Number, class Part>
FIXED_LANE_FUNCTION block_of_vertices load_vertices(const std::array<const Number*, 3>& from,
                                                    std::size_t i, Part part) {
  return {load<Number>(from[0], i, part), load<Number>(from[1], i, part),
          load<Number>(from[2], i, part)};
}

template <class Number, stores how>
FIXED_LANE_FUNCTION void store_vertices(void* to, std::size_t i, const block_of_vertices& v) {
#if FIXED_LANE_BYTES == 16
  if constexpr (sizeof(Number) == 4) {
    const int32x4x3_t all{int32x4_t(v.x), int32x4_t(v.y), int32x4_t(v.z)};
    return vst3q_s32(static_cast<std::int32_t*>(to) + 3 * i, all);
  }
#endif
  const registers_of_vertices r = registers_of(v);
  store<Number, how>(to, 3 * i, r.first);
  store<Number, how>(to, 3 * i + width, r.second);
  store<Number, how>(to, 3 * i + 2 * width, r.third);
}
template <class Number, stores how>
FIXED_LANE_FUNCTION void store_vertices(const std::array<Number*, 3>& to, std::size_t i,
                                        const block_of_vertices& v) {
  store<Number, how>(to[0], i, v.x);
  store<Number, how>(to[1], i, v.y);
  store<Number, how>(to[2], i, v.z);
}

#if FIXED_LANE_BYTES == 64

template <class Number>
FIXED_LANE_FUNCTION block_of_vertices load_vertices(const void* from, std::size_t i,
                                                    first_elements some) {
  const i32 first = load<Number>(from, 3 * i, some.third(0));
  const i32 second = load<Number>(from, 3 * i + width, some.third(1));
  const i32 third = load<Number>(from, 3 * i + 2 * width, some.third(2));
  return vertices_of(first, second, third);
}

template <class Number>
FIXED_LANE_FUNCTION void store_vertices(void* to, std::size_t i, const block_of_vertices& v,
                                        first_elements some) {
  const registers_of_vertices r = registers_of(v);
  store<Number>(to, 3 * i, r.first, some.third(0));
  store<Number>(to, 3 * i + width, r.second, some.third(1));
  store<Number>(to, 3 * i + 2 * width, r.third, some.third(2));
}
template <class Number>
FIXED_LANE_FUNCTION void store_vertices(const std::array<Number*, 3>& to, std::size_t i,
                                        const block_of_vertices& v, first_elements some) {
  store<Number>(to[0], i, v.x, some);
  store<Number>(to[1], i, v.y, some);
  store<Number>(to[2], i, v.z, some);
}

#endif

template <class Number>
FIXED_LANE_FUNCTION void store_points(void* to, std::size_t i, i32 x, i32 y) {
  const i32 low = lanes(from_points<0>);
  const i32 high = lanes(from_points<1>);
  constexpr unsigned odds = 0xaaaa;
  store<Number>(to, 2 * i, blend<odds>(permute(x, low), permute(y, low)));
  store<Number>(to, 2 * i + width, blend<odds>(permute(x, high), permute(y, high)));
}
template <class Number>
FIXED_LANE_FUNCTION void store_points(const std::array<Number*, 2>& to, std::size_t i, i32 x,
                                      i32 y) {
  store<Number>(to[0], i, x);
  store<Number>(to[1], i, y);
}

inline bool in_place(const void* from, const void* to) { return from == to; }
template <class Number>
bool in_place(const std::array<const Number*, 3>& from, const std::array<Number*, 3>& to) {
  return std::find_first_of(to.begin(), to.end(), from.begin(), from.end()) != to.end();
}

/// Whether the results from vertex i on are aligned to the register size.
template <class Number>
bool are_aligned(const void* to, std::size_t i) {
  return is_aligned<Number>(to, 3 * i);
}
template <class Number>
bool are_aligned(const std::array<Number*, 3>& to, std::size_t i) {
  return is_aligned<Number>(to[0], i) && is_aligned<Number>(to[1], i) &&
         is_aligned<Number>(to[2], i);
}

/// \}

// The functions of std::array lack the target attribute.
// NOLINTBEGIN(*-avoid-c-arrays)

/// A row of a transform, each number in every lane.
template <class Number>
struct product_row {
  i32 x, y, z, start;

  [[nodiscard]] FIXED_LANE_FUNCTION i32 of(const block_of_vertices& v, i32& bad) const {
    i32 sum = product<Number>(x, v.x, bad);
    sum = added<Number>(sum, product<Number>(y, v.y, bad), bad);
    sum = added<Number>(sum, product<Number>(z, v.z, bad), bad);
    return added<Number>(sum, start, bad);
  }
};

/// The same for sums that are rounded once, in lanes of twice the width. `start` includes the half
/// that rounds half up.
template <class Number>
struct sum_row {
  i32 x, y, z;
  u64 start;

  [[nodiscard]] FIXED_LANE_FUNCTION i64 sum(i64 of_x, i64 of_y, i64 of_z) const {
    return i64(start + u64(of_x) + u64(of_y) + u64(of_z));
  }
  [[nodiscard]] FIXED_LANE_FUNCTION i32 of(const block_of_vertices& v, i32& bad) const {
    constexpr int Point = Number::fraction_bits;
    constexpr rounding rule = Number::rules.multiply;
    constexpr rounding Rounding = rule == rounding::half_up ? rounding::floor : rule;
    constexpr overflow Overflow = Number::rules.product_range();
    if constexpr (sizeof(Number) == 2) {
      const u32 all = u32(start) + u32(x * v.x) + u32(y * v.y) + u32(z * v.z);
      return narrowed<Overflow>(rounded<Rounding, Point>(i32(all)), bad);
    } else {
      const wide_lanes of_x = products_by(x, v.x);
      const wide_lanes of_y = products_by(y, v.y);
      const wide_lanes of_z = products_by(z, v.z);
      return narrowed<Overflow, Point>(
          {biased<Rounding, Point>(sum(of_x.first, of_y.first, of_z.first)),
           biased<Rounding, Point>(sum(of_x.second, of_y.second, of_z.second))},
          bad);
    }
  }
};

template <class Number>
FIXED_LANE_FUNCTION i32 broadcast(Number x) {
  return i32{} + std::int32_t{x.raw()};
}

template <template <class> class Transform, class Number>
FIXED_LANE_FUNCTION auto row_of(const std::array<Number, 4>& by) {
  const i32 x = broadcast(by[0]);
  const i32 y = broadcast(by[1]);
  const i32 z = broadcast(by[2]);
  if constexpr (std::is_same_v<Transform<Number>, rounded_products<Number>>) {
    return product_row<Number>{x, y, z, broadcast(by[3])};
  } else {
    constexpr int Point = Number::fraction_bits;
    constexpr bool half_up = Number::rules.multiply == rounding::half_up;
    const auto start = static_cast<std::uint64_t>((std::int64_t{by[3].raw()} << Point) +
                                                  (half_up ? std::int64_t{1} << Point >> 1 : 0));
    const u64 lanes =
        sizeof(Number) == 2 ? u64(u32{} + static_cast<std::uint32_t>(start)) : u64{} + start;
    return sum_row<Number>{x, y, z, lanes};
  }
}

template <class Row>
struct transform_lanes {
  Row x, y, z;

  [[nodiscard]] FIXED_LANE_FUNCTION block_of_vertices of(const block_of_vertices& v,
                                                         i32& bad) const {
    return {x.of(v, bad), y.of(v, bad), z.of(v, bad)};
  }
};

/// @param of has a bit set for each lane whose overflow is recorded
template <class Number, stores how, overflow Overflow, class Transform, class From, class To>
FIXED_LANE_FUNCTION void transform_block(const Transform& t, const From& from, const To& to,
                                         std::size_t i, std::uint32_t of, fault_recorder& found) {
  i32 bad{};
  const block_of_vertices v = load_vertices<Number>(from, i, whole_block{});
  store_vertices<Number, how>(to, i, t.of(v, bad));
  note_overflows<Overflow>(bad, i, found, of);
}

/// Results of at least this many bytes bypass the caches. They are more than a core's share of the
/// last-level cache, so the first results would be evicted before anything reads them. Bypassing
/// keeps other data cached, and saves reading cache lines only to overwrite them.
inline constexpr std::size_t past_caches_from = std::size_t{8} << 20;

/// Transforms all whole blocks, and the vertices after them if there are masks. Always inlined, so
/// that the pointers stay in registers.
/// @return the number of vertices done
template <template <class> class Transform, class Number, class From, class To>
FIXED_LANE_FUNCTION std::size_t transform_blocks(const transform_rows<Number>& rows,
                                                 const From& from, const To& to, std::size_t count,
                                                 fault_recorder& found) {
  constexpr std::uint32_t all = ~0U;
  constexpr overflow Overflow = Transform<Number>::range;
  const transform_lanes<decltype(row_of<Transform>(rows[0]))> t{
      row_of<Transform>(rows[0]), row_of<Transform>(rows[1]), row_of<Transform>(rows[2])};
  std::size_t i = 0;
  if constexpr (may_store_past<Number>) {
    const bool many = count >= past_caches_from / (3 * sizeof(Number));
    std::size_t first = many ? 0 : width;
    while (first < width && !are_aligned<Number>(to, first)) ++first;
    if (first < width && !in_place(from, to)) {
      // The first block overlaps the second. Both compute the same values there.
      transform_block<Number, stores::cached, Overflow>(t, from, to, 0, (1U << first) - 1, found);
      for (i = first; count - i >= width; i += width) {
        transform_block<Number, stores::past_caches, Overflow>(t, from, to, i, all, found);
      }
      wait_for_stores();
      return i;
    }
  }
  for (; count - i >= width; i += width) {
    transform_block<Number, stores::cached, Overflow>(t, from, to, i, all, found);
  }
  if constexpr (has_masks) {
    if (i < count) {
      const first_elements rest(count - i);
      i32 bad{};
      const block_of_vertices v = load_vertices<Number>(from, i, rest);
      store_vertices<Number>(to, i, t.of(v, bad), rest);
      note_overflows<Overflow>(bad, i, found, rest.bits);
      i = count;
    }
  }
  return i;
}

/// Projects a block: x / z * constant and y / z * constant.
template <class Number>
FIXED_LANE_FUNCTION void project_block(const block_of_vertices& v, i32 constant, i32& x, i32& y,
                                       std::size_t index, fault_recorder& found) {
  const divisor_lanes low = divisor_of<Number>(lower(v.z));
  const divisor_lanes high = divisor_of<Number>(upper(v.z));
  std::uint32_t errors[4];
  std::uint32_t overflows[4];
  x = join(quotient<Number>(lower(v.x), low, errors[0], overflows[0]),
           quotient<Number>(upper(v.x), high, errors[1], overflows[1]));
  y = join(quotient<Number>(lower(v.y), low, errors[2], overflows[2]),
           quotient<Number>(upper(v.y), high, errors[3], overflows[3]));
  i32 bad{};
  x = product<Number>(x, constant, bad);
  y = product<Number>(y, constant, bad);
  const std::uint32_t no_quotient = errors[0] | errors[2] | (errors[1] | errors[3]) << (width / 2);
  note_lanes(fault::divide_error, no_quotient, index, found);
  constexpr policy Rules = Number::rules;
  if constexpr (Rules.quotient_range() != overflow::wrap ||
                Rules.product_range() != overflow::wrap) {
    const std::uint32_t out =
        (overflows[0] | overflows[2] | (overflows[1] | overflows[3]) << (width / 2) | bits(bad)) &
        ~no_quotient;
    note_lanes(fault::overflow, out, index, found);
  }
}

// NOLINTEND(*-avoid-c-arrays)

}  // namespace fixproof::detail::FIXED_LANES
#endif
