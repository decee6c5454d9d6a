/// @file
/// Conversions from and to float and double, for fixed/batch/detail/blocks.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

using half_f32 [[gnu::vector_size(FIXED_LANE_BYTES / 2)]] = float;

/// Loads half a block of floating-point numbers as doubles. If subnormals can change the result,
/// sets a bit of their exponents, because processors may take them for zero.
template <class Float, rounding Rounding, class Part>
FIXED_LANE_FUNCTION f64 load_doubles(const void* base, std::size_t index, Part part) {
  if constexpr (sizeof(Float) == 4) {
    half_i32 bits = load_half<std::int32_t>(base, index, part);
    if constexpr (Rounding == rounding::floor || Rounding == rounding::ceiling) {
      constexpr std::int32_t normal = 1 << 23;
      const half_i32 magnitude = bits & (std::numeric_limits<std::int32_t>::max)();
      bits |= half_i32(magnitude > 0) & half_i32(magnitude < normal) & normal;
    }
    return __builtin_convertvector(half_f32(bits), f64);
  } else {
    const f64 x = load_half_doubles(base, index, part);
    if constexpr (Rounding == rounding::floor || Rounding == rounding::ceiling) {
      constexpr std::int64_t normal = std::int64_t{1} << 52;
      const i64 magnitude = i64(x) & (std::numeric_limits<std::int64_t>::max)();
      return f64(i64(x) | (i64(magnitude > 0) & i64(magnitude < normal) & normal));
    } else {
      return x;
    }
  }
}

/// Returns `twice` / 2 rounded by rule Rounding, for |twice| < 2^51, in every rounding mode.
template <rounding Rounding>
FIXED_LANE_FUNCTION half_i32 half_rounded(f64 twice) {
  if constexpr (Rounding == rounding::half_up) {
    return low_words(i64(u64(whole<true>(twice) + 1) >> 1));
  } else if constexpr (Rounding == rounding::floor) {
    return low_words(i64(u64(whole<true>(twice)) >> 1));
  } else if constexpr (Rounding == rounding::ceiling) {
    // Unsigned, because the negative of the lowest integer is itself.
    return half_i32(0 - half_u32(low_words(i64(u64(whole<true>(-twice)) >> 1))));
  } else if constexpr (Rounding == rounding::half_even) {
    const i64 floor = whole<true>(twice);
    const i64 up = i64(u64(floor + 1) >> 1);
    // `twice` is an integer, and half of it may be a tie, if the floors of `twice` and of -`twice`
    // add up to zero.
    const half_i32 halves = low_words(floor);
    const half_i32 nearest = low_words(up);
    const i64 sum = i64(u64(floor) + u64(whole<true>(-twice)));
    const half_i32 exact = half_i32(low_words(sum) == 0);
    return nearest - (nearest & halves & exact & 1);
  } else {
    // Truncation takes the ceiling of a negative number.
    const half_i32 below = low_words(negative(i64(twice)));
    const half_i32 half = low_words(i64(u64(whole<false>(twice) + 1) >> 1));
    const half_i32 down = low_words(i64(u64(whole<false>(twice)) >> 1));
    return Rounding == rounding::half_away ? (half & ~below) | (down & below)
                                           : (down & ~below) | (half & below);
  }
}

/// Half a block of numbers from floating-point numbers. note() computes lanes that may be out of
/// range, or NaN, one by one.
template <class Number, class Float>
struct from_float_blocks {
  using number = Number;
  using limits = std::numeric_limits<typename Number::raw_type>;
  using check = std::uint32_t;  // the lanes that note() computes one by one
  static constexpr rounding Rounding = Number::rules.multiply;
  static constexpr std::size_t size = width / 2;
  static constexpr bool in_groups = true;
  static constexpr bool stores_first = true;
  void* out;
  const void* x;

  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION half_i32 at(std::size_t i, Part part,
                                                std::uint32_t& missing) const {
    constexpr bool wraps = Number::rules.range == overflow::wrap;
    constexpr double lowest = wraps ? -0x1p50 : double{(limits::min)()};
    constexpr double highest = wraps ? 0x1p50 : double{(limits::max)()};
    constexpr double twice_one = std::uint64_t{2} << Number::fraction_bits;
    const f64 twice = load_doubles<Float, Rounding>(x, i, part) * twice_one;
    const std::uint32_t there =
        bits_at_least(twice, f64{} + 2 * lowest) & bits_at_least(f64{} + 2 * highest, twice);
    missing |= there ^ ((1U << size) - 1);
    return half_rounded<Rounding>(twice);
  }
  FIXED_LANE_FUNCTION static bool is_clean(std::uint32_t missing) { return missing == 0; }
  template <class Part>
  FIXED_LANE_FUNCTION void note(std::size_t i, Part part, fault_recorder& found) const {
    std::uint32_t missing = 0;
    store<Number>(out, i, at(i, part, missing), part);
    missing_from_floats<Number, Float>(x, out, i, missing, found);
  }
};

#if FIXED_LANE_BYTES == 64

/// Half a block of 32-bit numbers from floating-point numbers, with halves up.
///
/// Doubles from 1.5 2^36 up to but without 1.5 2^36 + 2^32 have equal upper 16 bits, then an
/// integer of 32 bits, then a fraction. So the sum of a number in ulps and such a double has the
/// floor of the number, and tells whether that is in range. The ends are doubles, so rounding the
/// sum down crosses neither. The number itself is in ones, not ulps, and so is the sum: the bits
/// are the same, but for the exponent, and no product is needed.
template <class Number, class Float>
struct half_up_halves {
  using number = Number;
  using check = i64;  // all bits of the fields; lanes out of range set some of the upper 16
  static constexpr std::size_t size = width / 2;
  void* out;
  const void* x;

  /// Returns 16 bits that are zero if the result is in range, 32 of the result, and 16 of a
  /// fraction.
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION i64 fields(std::size_t i, Part part) const {
    constexpr double one = std::uint64_t{1} << Number::fraction_bits;
    // The sum for 0. Its 2^31 makes room for negative integers.
    const f64 place = f64{} + (0x1.8p36 + 0x1p31 + 0.5) / one;
    return i64(sum_down(load_doubles<Float, rounding::half_up>(x, i, part), place)) ^ i64(place);
  }
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION half_i32 at(std::size_t i, Part part, i64& seen) const {
    seen = fields(i, part);
    return low_words(seen >> 16);
  }
  // Unlike half_up_blocks, which tests with a constant that its loop loads once.
  FIXED_LANE_FUNCTION static bool is_clean(i64 seen) { return !any_bit(u64(seen) >> 48); }
};

/// The same for a block.
template <class Number, class Float>
struct half_up_blocks {
  using halves = half_up_halves<Number, Float>;
  using number = Number;
  using check = i64;
  static constexpr std::size_t size = width;
  static constexpr bool in_groups = true;
  static constexpr bool stores_first = true;
  void* out;
  const void* x;

  [[nodiscard]] FIXED_LANE_FUNCTION halves half() const { return {out, x}; }
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION i32 at(std::size_t i, Part part, i64& seen) const {
    const i64 low = half().fields(i, part);
    const i64 high = half().fields(i + width / 2, part.upper());
    seen |= low | high;
    return middles(low, high);
  }
  FIXED_LANE_FUNCTION static bool is_clean(i64 seen) { return !any_of_upper_16_bits(seen); }
  template <class Part>
  FIXED_LANE_FUNCTION void note(std::size_t i, Part part, fault_recorder& found) const {
    const from_float_blocks<Number, Float> any{out, x};
    any.note(i, part, found);
    any.note(i + width / 2, part.upper(), found);
  }
};

template <class Number, class Float>
using blocks_from_floats =
    std::conditional_t<Number::rules.multiply == rounding::half_up && sizeof(Number) == 4,
                       half_up_blocks<Number, Float>, from_float_blocks<Number, Float>>;

#else

template <class Number, class Float>
using blocks_from_floats = from_float_blocks<Number, Float>;

#endif

/// What operations without faults have in common.
struct no_faults {
  using check = no_faults;
  static constexpr bool in_groups = true;

  FIXED_LANE_FUNCTION static bool is_clean(no_faults /*seen*/) { return true; }
};

template <class Number>
struct to_double_blocks : no_faults {
  using number = double;
  static constexpr std::size_t size = width / 2;
  void* out;
  const void* x;

  FIXED_LANE_FUNCTION to_double_blocks(void* to, const void* from) : out(to), x(from) {}
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION f64 at(std::size_t i, Part part, no_faults& /*seen*/) const {
    constexpr double unit = 1.0 / static_cast<double>(std::uint64_t{1} << Number::fraction_bits);
    return doubles(load_half<Number>(x, i, part)) * unit;
  }
};

/// Tells whether floats() rounds to nearest, ties to even. Tries one tie whose even neighbour is
/// below and one whose even neighbour is above.
FIXED_LANE_FUNCTION bool floats_are_nearest() {
  if constexpr (has_nearest_floats) return true;
  constexpr std::int32_t tie = (1 << 24) + 1;
  const f32 down = floats(unknown(i32{} + tie));
  const f32 up = floats(unknown(i32{} + (tie + 2)));
  return static_cast<std::int32_t>(down[0]) == tie - 1 &&
         static_cast<std::int32_t>(up[0]) == tie + 3;
}

template <class Number>
struct to_float_blocks : no_faults {
  using number = float;
  static constexpr std::size_t size = width;
  void* out;
  const void* x;

  FIXED_LANE_FUNCTION to_float_blocks(void* to, const void* from) : out(to), x(from) {}
  template <class Part>
  [[nodiscard]] FIXED_LANE_FUNCTION f32 at(std::size_t i, Part part, no_faults& /*seen*/) const {
    constexpr float unit = 1.0F / static_cast<float>(std::uint64_t{1} << Number::fraction_bits);
    return floats(load<Number>(x, i, part)) * unit;
  }
  FIXED_LANE_FUNCTION static bool is_exact() { return floats_are_nearest(); }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
