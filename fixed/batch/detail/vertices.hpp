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

}  // namespace fixproof::detail::FIXED_LANES
#endif
