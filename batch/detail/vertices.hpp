/// \file
/// Vertices and points in vector registers; see batch/detail/lanes.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// \name Conversion between interleaved (x y z ..., x y ...) and per-coordinate blocks
/// \{

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
template <class Raw>
bool is_register_aligned(const void* base, std::size_t index) {
  return (reinterpret_cast<std::uintptr_t>(base) + index * sizeof(Raw)) % FIXED_LANE_BYTES == 0;
}

/// Prefetches the data that is read eight AVX-512 blocks later. In a stream of three registers per
/// block, the hardware prefetcher does not look far enough ahead. An address beyond the end of an
/// array causes no access.
/// \param index  the next byte to read
/// \tparam block the bytes read between two calls
template <std::size_t block>
FIXED_LANE_FUNCTION void prefetch(const void* base, std::size_t index) {
  constexpr std::uintptr_t distance = 1536;
  const auto at = reinterpret_cast<std::uintptr_t>(base) + index + distance;
  for (std::uintptr_t line = 0; line < block; line += 64) {
    __builtin_prefetch(reinterpret_cast<const void*>(at + line));
  }
}

// NOLINTEND(*-reinterpret-cast,performance-no-int-to-ptr)

/// Loads the block of vertices that starts at `index`.
template <class Raw>
FIXED_LANE_FUNCTION block_of_vertices load_vertices(const void* base, std::size_t index) {
  constexpr std::size_t vertex = 3 * sizeof(Raw);
  prefetch<vertex * width>(base, vertex * index);
  const i32 first = load<Raw>(base, 3 * index);
  const i32 second = load<Raw>(base, 3 * index + width);
  const i32 third = load<Raw>(base, 3 * index + 2 * width);
  return vertices_of(first, second, third);
}

template <class Raw, stores how>
FIXED_LANE_FUNCTION void store_vertices(void* base, std::size_t index, const block_of_vertices& v) {
  const registers_of_vertices r = registers_of(v);
  store<Raw, how>(base, 3 * index, r.first);
  store<Raw, how>(base, 3 * index + width, r.second);
  store<Raw, how>(base, 3 * index + 2 * width, r.third);
}

#if FIXED_LANE_BYTES == 64

/// The part of register `i` of three that holds some vertices.
FIXED_LANE_FUNCTION first_elements part_of(first_elements vertices, std::size_t i) {
  // Three bits for each vertex.
  const std::uint64_t all = vertices.bits;
  const auto count = 3 * static_cast<std::size_t>(__builtin_popcountll(all));
  return first_elements((std::min)(width, count - (std::min)(count, width * i)));
}

template <class Raw>
FIXED_LANE_FUNCTION block_of_vertices load_vertices(const void* base, std::size_t index,
                                                    first_elements some) {
  const i32 first = load<Raw>(base, 3 * index, part_of(some, 0));
  const i32 second = load<Raw>(base, 3 * index + width, part_of(some, 1));
  const i32 third = load<Raw>(base, 3 * index + 2 * width, part_of(some, 2));
  return vertices_of(first, second, third);
}

template <class Raw>
FIXED_LANE_FUNCTION void store_vertices(void* base, std::size_t index, const block_of_vertices& v,
                                        first_elements some) {
  const registers_of_vertices r = registers_of(v);
  store<Raw>(base, 3 * index, r.first, part_of(some, 0));
  store<Raw>(base, 3 * index + width, r.second, part_of(some, 1));
  store<Raw>(base, 3 * index + 2 * width, r.third, part_of(some, 2));
}

#endif

template <class Raw>
FIXED_LANE_FUNCTION void store_points(void* base, std::size_t index, i32 x, i32 y) {
  const i32 low = lanes(from_points<0>);
  const i32 high = lanes(from_points<1>);
  constexpr unsigned odds = 0xaaaa;
  store<Raw>(base, 2 * index, blend<odds>(permute(x, low), permute(y, low)));
  store<Raw>(base, 2 * index + width, blend<odds>(permute(x, high), permute(y, high)));
}

/// \}

// The functions of std::array lack the target attribute.
// NOLINTBEGIN(*-avoid-c-arrays)

/// The coefficients of a transform, each broadcast to every lane.
struct broadcast_transform {
  i32 rows[3][4];
};

template <class Raw>
FIXED_LANE_FUNCTION broadcast_transform broadcast(const raw_transform<Raw>& transform) {
  broadcast_transform result;  // NOLINT(*-pro-type-member-init): each lane is set below
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      result.rows[i][k] = i32{} + std::int32_t{transform[i][k]};
    }
  }
  return result;
}

template <class N>
FIXED_LANE_FUNCTION i32 coordinate(const i32 (&row)[4], const block_of_vertices& v, i32& bad) {
  i32 sum = product<N>(row[0], v.x, bad);
  sum = added<N>(sum, product<N>(row[1], v.y, bad), bad);
  sum = added<N>(sum, product<N>(row[2], v.z, bad), bad);
  return added<N>(sum, row[3], bad);
}

template <class N>
FIXED_LANE_FUNCTION block_of_vertices transformed_block(const broadcast_transform& t,
                                                        const block_of_vertices& v, i32& bad) {
  return {coordinate<N>(t.rows[0], v, bad), coordinate<N>(t.rows[1], v, bad),
          coordinate<N>(t.rows[2], v, bad)};
}

/// \name Layouts of vertices in memory
/// \{

/// x y z x y z ...
template <class Raw>
struct interleaved_vertices {
  const void* in;
  void* out;

  [[nodiscard]] FIXED_LANE_FUNCTION block_of_vertices load(std::size_t i) const {
    return load_vertices<Raw>(in, i);
  }
  template <stores how>
  FIXED_LANE_FUNCTION void store(std::size_t i, const block_of_vertices& v) const {
    store_vertices<Raw, how>(out, i, v);
  }
  [[nodiscard]] FIXED_LANE_FUNCTION block_of_vertices load_some(std::size_t i,
                                                                first_elements some) const {
    return load_vertices<Raw>(in, i, some);
  }
  FIXED_LANE_FUNCTION void store_some(std::size_t i, const block_of_vertices& v,
                                      first_elements some) const {
    store_vertices<Raw>(out, i, v, some);
  }
  [[nodiscard]] bool in_place() const { return in == out; }
  /// Whether the results from vertex i on are aligned to the register size.
  [[nodiscard]] bool is_aligned(std::size_t i) const {
    return is_register_aligned<Raw>(out, 3 * i);
  }
};

/// Each coordinate in its own array.
template <class Raw>
struct vertex_columns {
  std::array<const void*, 3> in;
  std::array<void*, 3> out;

  [[nodiscard]] FIXED_LANE_FUNCTION block_of_vertices load(std::size_t i) const {
    using FIXED_LANES::load;
    return {load<Raw>(in[0], i), load<Raw>(in[1], i), load<Raw>(in[2], i)};
  }
  template <stores how>
  FIXED_LANE_FUNCTION void store(std::size_t i, const block_of_vertices& v) const {
    using FIXED_LANES::store;
    store<Raw, how>(out[0], i, v.x);
    store<Raw, how>(out[1], i, v.y);
    store<Raw, how>(out[2], i, v.z);
  }
  [[nodiscard]] FIXED_LANE_FUNCTION block_of_vertices load_some(std::size_t i,
                                                                first_elements some) const {
    using FIXED_LANES::load;
    return {load<Raw>(in[0], i, some), load<Raw>(in[1], i, some), load<Raw>(in[2], i, some)};
  }
  FIXED_LANE_FUNCTION void store_some(std::size_t i, const block_of_vertices& v,
                                      first_elements some) const {
    using FIXED_LANES::store;
    store<Raw>(out[0], i, v.x, some);
    store<Raw>(out[1], i, v.y, some);
    store<Raw>(out[2], i, v.z, some);
  }
  [[nodiscard]] bool in_place() const {
    return std::any_of(out.begin(), out.end(), [this](const void* to) {
      return std::find(in.begin(), in.end(), to) != in.end();
    });
  }
  [[nodiscard]] bool is_aligned(std::size_t i) const {
    return std::all_of(out.begin(), out.end(),
                       [i](const void* to) { return is_register_aligned<Raw>(to, i); });
  }
};

/// \}

/// \param of has a bit set for each lane whose overflow is recorded
template <class N, stores how, class Places>
FIXED_LANE_FUNCTION void transform_block(const broadcast_transform& t, const Places& places,
                                         std::size_t i, std::uint32_t of, fault_recorder& found) {
  i32 bad{};
  places.template store<how>(i, transformed_block<N>(t, places.load(i), bad));
  note_overflows<sums_and_products<N>>(bad, i, found, of);
}

/// Results of at least this many bytes bypass the caches. They are more than a core's share of the
/// last-level cache, so the first results would be evicted before anything reads them. Bypassing
/// keeps other data cached, and saves reading cache lines only to overwrite them.
inline constexpr std::size_t past_caches_from = std::size_t{8} << 20;

/// Transforms all whole blocks, and the vertices after them if there are masks. Always inlined, so
/// that the pointers of `places` stay in registers: a copy of pointers that were stored one by one
/// would wait for those stores.
/// \return the number of vertices done
template <class N, class Places>
FIXED_LANE_FUNCTION std::size_t transform_blocks(const raw_transform<typename N::raw_type>& by,
                                                 const Places& places, std::size_t count,
                                                 fault_recorder& found) {
  constexpr std::uint32_t all = ~0U;
  const broadcast_transform t = broadcast<typename N::raw_type>(by);
  std::size_t i = 0;
  if constexpr (may_store_past<typename N::raw_type>) {
    const bool many = count >= past_caches_from / (3 * sizeof(N));
    std::size_t first = many ? 0 : width;
    while (first < width && !places.is_aligned(first)) ++first;
    if (first < width && !places.in_place()) {
      // The first block overlaps the second. Both compute the same values there.
      transform_block<N, stores::cached>(t, places, 0, (1U << first) - 1, found);
      for (i = first; count - i >= width; i += width) {
        transform_block<N, stores::past_caches>(t, places, i, all, found);
      }
      wait_for_stores();
      return i;
    }
  }
  for (; count - i >= width; i += width) {
    transform_block<N, stores::cached>(t, places, i, all, found);
  }
  if constexpr (has_masks) {
    if (i < count) {
      const first_elements rest(count - i);
      i32 bad{};
      places.store_some(i, transformed_block<N>(t, places.load_some(i, rest), bad), rest);
      note_overflows<sums_and_products<N>>(bad, i, found, rest.bits);
      i = count;
    }
  }
  return i;
}

/// Projects a block: x / z * constant and y / z * constant.
template <class N>
FIXED_LANE_FUNCTION void project_block(const block_of_vertices& v, i32 constant, i32& x, i32& y,
                                       std::size_t index, fault_recorder& found) {
  const divisor_lanes low = divisor_of<N>(lower(v.z));
  const divisor_lanes high = divisor_of<N>(upper(v.z));
  std::uint32_t errors[4];
  std::uint32_t overflows[4];
  x = join(quotient<N>(lower(v.x), low, errors[0], overflows[0]),
           quotient<N>(upper(v.x), high, errors[1], overflows[1]));
  y = join(quotient<N>(lower(v.y), low, errors[2], overflows[2]),
           quotient<N>(upper(v.y), high, errors[3], overflows[3]));
  i32 bad{};
  x = product<N>(x, constant, bad);
  y = product<N>(y, constant, bad);
  const std::uint32_t no_quotient = errors[0] | errors[2] | (errors[1] | errors[3]) << (width / 2);
  if (no_quotient != 0) [[unlikely]] {
    found.note_bits(fault::divide_error, no_quotient, index);
  }
  constexpr policy P = N::rules;
  if constexpr (P.quotient_range() != overflow::wrap || P.product_range() != overflow::wrap) {
    const std::uint32_t out =
        (overflows[0] | overflows[2] | (overflows[1] | overflows[3]) << (width / 2) | bits(bad)) &
        ~no_quotient;
    if (out != 0) [[unlikely]] {
      found.note_bits(fault::overflow, out, index);
    }
  }
}

// NOLINTEND(*-avoid-c-arrays)

}  // namespace fixproof::detail::FIXED_LANES
#endif
