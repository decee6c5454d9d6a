/// @file
/// Transforms and projections of vertices in vector registers; see fixed/batch/detail/lanes.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

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
  /// @pre has_half_blocks<Number>
  [[nodiscard]] FIXED_LANE_FUNCTION u64 of(const half_block_of_vertices& v) const {
    return term(x, v.x) + term(y, v.y) + term(z, v.z) + u64(start);
  }
  [[nodiscard]] FIXED_LANE_FUNCTION static u64 term(i32 a, i64 b) {
    constexpr int Point = Number::fraction_bits;
    return u64(biased<Number::rules.multiply, Point>(mul_even(i64(a), b))) >> Point;
  }
};

/// The same for sums that are rounded once, in lanes of twice the width. `start` includes the half
/// that rounds half up.
template <class Number>
struct sum_row {
  static constexpr int Point = Number::fraction_bits;
  static constexpr rounding rule = Number::rules.multiply;
  static constexpr rounding Rounding = rule == rounding::half_up ? rounding::floor : rule;

  i32 x, y, z;
  u64 start;

  [[nodiscard]] FIXED_LANE_FUNCTION i64 sum(i64 of_x, i64 of_y, i64 of_z) const {
    return i64(start + u64(of_x) + u64(of_y) + u64(of_z));
  }
  [[nodiscard]] FIXED_LANE_FUNCTION i32 of(const block_of_vertices& v, i32& bad) const {
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
  /// @pre has_half_blocks<Number>
  [[nodiscard]] FIXED_LANE_FUNCTION u64 of(const half_block_of_vertices& v) const {
    const i64 exact = sum(mul_even(i64(x), v.x), mul_even(i64(y), v.y), mul_even(i64(z), v.z));
    return u64(biased<Rounding, Point>(exact)) >> Point;
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
  [[nodiscard]] FIXED_LANE_FUNCTION half_block_of_vertices
  of(const half_block_of_vertices& v) const {
    return {i64(x.of(v)), i64(y.of(v)), i64(z.of(v))};
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
      if constexpr (has_half_blocks<Number>) {
        if (rest.count <= width / 2) {
          store_half_block<Number>(to, i, t.of(load_half_block<Number>(from, i, rest)), rest);
          return count;
        }
      }
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
