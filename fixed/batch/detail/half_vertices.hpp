/// @file
/// Half blocks of vertices, which take half the products of a block; see
/// fixed/batch/detail/lanes.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// Numbers in the lower halves of 64-bit lanes. The upper halves mean nothing.
struct half_block_of_vertices {
  i64 x, y, z;
};

/// Whether transforms have half blocks of these numbers.
template <class Number>
inline constexpr bool has_half_blocks =
    has_masks && sizeof(Number) == 4 &&
    Number::rules.range == overflow::wrap&& Number::rules.product_range() == overflow::wrap;

#if FIXED_LANE_BYTES == 64

/// The places of component c in two registers x y z x y z ...
template <std::int32_t c>
inline constexpr lane_array places_of_component = [] {
  lane_array from{};
  for (std::size_t lane = 0; lane < width; ++lane) {
    from[lane] = static_cast<std::int32_t>(lane / 2 * 3) + c;
  }
  return from;
}();

/// For each lane of register i of x y z x y z ..., where its number is: in x, behind it in y, or
/// in z.
template <std::size_t i>
inline constexpr lane_array places_of_vertices = [] {
  lane_array from{};
  for (std::size_t lane = 0; lane < width; ++lane) {
    const std::size_t word = width * i + lane;
    from[lane] = static_cast<std::int32_t>(word / 3 * 2 + (word % 3 == 1 ? width : 0));
  }
  return from;
}();

template <class Number>
FIXED_LANE_FUNCTION half_block_of_vertices load_half_block(const void* from, std::size_t i,
                                                           first_elements some) {
  const i32 first = load<Number>(from, 3 * i, some.third(0));
  const i32 second = load<Number>(from, 3 * i + width, some.third(1));
  return {i64(permute(first, lanes(places_of_component<0>), second)),
          i64(permute(first, lanes(places_of_component<1>), second)),
          i64(permute(first, lanes(places_of_component<2>), second))};
}
template <class Number>
FIXED_LANE_FUNCTION half_block_of_vertices load_half_block(const std::array<const Number*, 3>& from,
                                                           std::size_t i, first_elements some) {
  return {widened(load_half<Number>(from[0], i, some)),
          widened(load_half<Number>(from[1], i, some)),
          widened(load_half<Number>(from[2], i, some))};
}

template <class Number>
FIXED_LANE_FUNCTION void store_half_block(void* to, std::size_t i, const half_block_of_vertices& v,
                                          first_elements some) {
  const i32 low = lanes(places_of_vertices<0>);
  const i32 high = lanes(places_of_vertices<1>);
  store<Number>(to, 3 * i,
                blend<lanes_of(2, 0)>(permute(i32(v.x), low, i32(v.y)), permute(i32(v.z), low)),
                some.third(0));
  store<Number>(to, 3 * i + width,
                blend<lanes_of(2, 1)>(permute(i32(v.x), high, i32(v.y)), permute(i32(v.z), high)),
                some.third(1));
}
template <class Number>
FIXED_LANE_FUNCTION void store_half_block(const std::array<Number*, 3>& to, std::size_t i,
                                          const half_block_of_vertices& v, first_elements some) {
  store<Number>(to[0], i, low_words(v.x), some);
  store<Number>(to[1], i, low_words(v.y), some);
  store<Number>(to[2], i, low_words(v.z), some);
}

#endif

}  // namespace fixproof::detail::FIXED_LANES
#endif
