/// @file
/// The vector form of detail::nearest_sine(); see fixed/batch/detail/lanes.hpp.
///
/// The even and the odd lanes of a block are computed in separate registers of 64-bit lanes.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// The `turns` of detail::nearest_sine().
struct turn_lanes {
  u64 even, odd;
};

/// Returns the turns of the angles in the lower halves, which are in units of 2^-16 radians.
FIXED_LANE_FUNCTION u64 turns_of_even(i64 angle, std::uint64_t ahead) {
  constexpr auto lower_word = static_cast<std::int64_t>(turns_per_unit & 0xffffffff);
  constexpr auto upper_word = static_cast<std::int64_t>(turns_per_unit >> 32);
  const u64 lower = u64(mul_even(angle, i64{} + lower_word));
  const u64 upper = unknown(u64(mul_even(angle, i64{} + upper_word)));
  return lower + (upper << 32) + turns_bias + ahead;
}

template <int Point>
FIXED_LANE_FUNCTION turn_lanes turns_of(i32 raw, std::uint64_t ahead) {
  const i32 angle = raw << (16 - Point);
  return {turns_of_even(i64(angle), ahead), turns_of_even(odd_lanes(angle), ahead)};
}

/// The vector form of detail::fast_cosine().
FIXED_LANE_FUNCTION u64 fast_cosine_of(u64 d) {
  const auto& c = fast_coefficients;
  const u64 z = unknown(u64(mul_even(i64(d), i64(d))) >> 31);
  u64 factor = c[4] - (mul_even(z, u64{} + c[5]) >> 31);
  factor = c[3] - (mul_even(z, factor) >> 31);
  factor = c[2] - (mul_even(z, factor) >> 31);
  factor = c[1] - (mul_even(z, factor) >> 32);
  return c[0] - mul_even(z, factor);
}

/// The magnitudes of sines, before rounding::dropped bits are dropped.
template <int Point>
FIXED_LANE_FUNCTION u64 biased_sines_of(u64 turns) {
  return fast_cosine_of((turns - quarter_turn) >> 31) + fast_rounding<Point>::bias;
}

/// The bits of fast_rounding::doubtful, shifted into the lower 32.
inline constexpr int unneeded_bits = 34;
template <int Point>
inline constexpr auto doubtful_mask = static_cast<std::int32_t>(fast_rounding<Point>::doubtful >>
                                                                unneeded_bits);

/// Returns the sines of a block. Sets the bits of `doubtful` for lanes that may be wrong.
template <int Point>
FIXED_LANE_FUNCTION i32 sines_of(const turn_lanes& turns, std::uint32_t& doubtful) {
  using rounding = fast_rounding<Point>;
  const i32 sign = interleaved(turns.even >> 32, turns.odd) >> 31;
  const u64 even = biased_sines_of<Point>(turns.even);
  const u64 odd = biased_sines_of<Point>(turns.odd);
  doubtful |= zero_bits(interleaved(even >> unneeded_bits, odd >> (unneeded_bits - 32)) &
                        doubtful_mask<Point>);
  const i32 magnitude = interleaved(even >> rounding::dropped, odd >> (rounding::dropped - 32));
  return (magnitude ^ sign) - sign;
}

/// The same for half a block, whose angles are in 64-bit lanes.
template <int Point>
FIXED_LANE_FUNCTION half_i32 sines_of(u64 turns, std::uint32_t& doubtful) {
  const half_i32 sign = low_words(negative(i64(turns)));
  const u64 sums = biased_sines_of<Point>(turns);
  doubtful |= zero_bits(low_words(i64(sums >> unneeded_bits)) & doubtful_mask<Point>);
  const half_i32 magnitude = low_words(i64(sums >> fast_rounding<Point>::dropped));
  return (magnitude ^ sign) - sign;
}

/// detail::nearest_sine(), lane by lane.
template <int Point>
FIXED_LANE_TARGET __attribute__((noinline)) i32 nearest_sines(i32 raw, std::uint64_t ahead) {
  for (std::size_t i = 0; i < width; ++i) {
    raw[i] = nearest_sine<Point>(raw[i], ahead);
  }
  return raw;
}

/// The angles of a part of a block, and their turns: half a block is in 64-bit lanes.
template <class Raw, int Point>
struct block_of_angles {
  i32 raw;
  template <class Part>
  FIXED_LANE_FUNCTION block_of_angles(const void* angles, std::size_t i, Part part)
      : raw(load<Raw>(angles, i, part)) {}
  [[nodiscard]] FIXED_LANE_FUNCTION turn_lanes turns(std::uint64_t ahead) const {
    return turns_of<Point>(raw, ahead);
  }
};
template <class Raw, int Point>
struct half_block_of_angles {
  half_i32 raw;
  template <class Part>
  FIXED_LANE_FUNCTION half_block_of_angles(const void* angles, std::size_t i, Part part)
      : raw(load_half<Raw>(angles, i, part)) {}
  [[nodiscard]] FIXED_LANE_FUNCTION u64 turns(std::uint64_t ahead) const {
    return turns_of_even(widened(raw << (16 - Point)), ahead);
  }
};

/// What sines_of() leaves to nearest_sines(). A short span leaves it to the caller instead, because
/// registers are saved for a call even if it is not made.
template <bool short_span>
struct doubts {
  using check = std::conditional_t<short_span, std::uint32_t, no_faults>;
  static constexpr bool in_groups = false;

  FIXED_LANE_FUNCTION static bool is_clean(std::uint32_t doubtful) { return doubtful == 0; }
  FIXED_LANE_FUNCTION static bool is_clean(no_faults /*seen*/) { return true; }
};

/// @tparam Angles block_of_angles or half_block_of_angles
template <class Raw, int Point, bool short_span,
          template <class, int> class Angles = block_of_angles>
struct sine_blocks : doubts<short_span> {
  using number = Raw;
  static constexpr std::size_t size = width;
  const void* angles;
  void* out;
  std::uint64_t ahead;

  FIXED_LANE_FUNCTION sine_blocks(const void* from, void* to, std::uint64_t turns)
      : angles(from), out(to), ahead(turns) {}
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION auto at(std::size_t i, Part part,
                                            typename doubts<short_span>::check& seen) const {
    const Angles<Raw, Point> block(angles, i, part);
    std::uint32_t doubtful = 0;
    auto values = sines_of<Point>(block.turns(ahead), doubtful);
    if constexpr (short_span) {
      seen = doubtful & part.bits;
    } else if ((doubtful & part.bits) != 0) [[unlikely]] {
      values = nearest_sines<Point>(block.raw, ahead);
    }
    return values;
  }
};

/// Cosines and sines, or where they go.
template <class Type>
struct cosines_and_sines {
  Type cosines;
  Type sines;
};

template <class Raw, class Lanes, class Part>
FIXED_LANE_FUNCTION void store(const cosines_and_sines<void*>& out, std::size_t i,
                               const cosines_and_sines<Lanes>& x, Part part) {
  store<Raw>(out.sines, i, x.sines, part);
  store<Raw>(out.cosines, i, x.cosines, part);
}

template <class Raw, int Point, bool short_span,
          template <class, int> class Angles = block_of_angles>
struct sine_cosine_blocks : doubts<short_span> {
  using number = Raw;
  static constexpr std::size_t size = width;
  const void* angles;
  cosines_and_sines<void*> out;

  FIXED_LANE_FUNCTION sine_cosine_blocks(const void* from, void* cosines, void* sines)
      : angles(from), out{cosines, sines} {}
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION auto at(std::size_t i, Part part,
                                            typename doubts<short_span>::check& seen) const {
    const Angles<Raw, Point> block(angles, i, part);
    std::uint32_t doubtful = 0;
    auto sines = sines_of<Point>(block.turns(0), doubtful);
    auto cosines = sines_of<Point>(block.turns(quarter_turn), doubtful);
    if constexpr (short_span) {
      seen = doubtful & part.bits;
    } else if ((doubtful & part.bits) != 0) [[unlikely]] {
      sines = nearest_sines<Point>(block.raw, 0);
      cosines = nearest_sines<Point>(block.raw, quarter_turn);
    }
    return cosines_and_sines<decltype(sines)>{cosines, sines};
  }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
