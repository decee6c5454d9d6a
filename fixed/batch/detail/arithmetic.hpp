/// @file
/// The rules of fixed/policy.hpp, applied to blocks of numbers; see fixed/batch/detail/lanes.hpp.
///
/// A function sets a lane of `bad` to ones if its result is out of range, and leaves it unchanged
/// otherwise. Quotients assign `errors` and `overflows`, which have a bit set for each lane that
/// has no result or a result out of range. Roots add bits to `errors`.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// Adds detail::bias() to sums whose last Point bits are dropped afterwards.
template <rounding Rounding, int Point>
FIXED_LANE_FUNCTION i64 biased(i64 sum) {
  constexpr std::int64_t unit = std::int64_t{1} << Point;
  if constexpr (Point == 0) {
    return sum;
  } else if constexpr (Rounding == rounding::half_up) {
    return sum + unit / 2;
  } else if constexpr (Rounding == rounding::half_away) {
    return sum + unit / 2 + negative(sum);
  } else if constexpr (Rounding == rounding::half_even) {
    return sum + (unit / 2 - 1) + i64(u64(sum) >> Point & 1);
  } else if constexpr (Rounding == rounding::truncate) {
    return sum + (negative(sum) & (unit - 1));
  } else if constexpr (Rounding == rounding::ceiling) {
    return sum + (unit - 1);
  } else {
    static_assert(Rounding == rounding::floor);
    return sum;
  }
}

/// Does the same in 32-bit lanes, and drops the bits.
template <rounding Rounding, int Point>
FIXED_LANE_FUNCTION i32 rounded(i32 sum) {
  constexpr std::int32_t unit = 1 << Point;
  if constexpr (Point == 0) return sum;
  if constexpr (Rounding == rounding::half_up) sum += unit / 2;
  if constexpr (Rounding == rounding::half_away) sum += unit / 2 + (sum >> 31);
  if constexpr (Rounding == rounding::half_even) sum += unit / 2 - 1 + (sum >> Point & 1);
  if constexpr (Rounding == rounding::truncate) sum += (sum >> 31) & (unit - 1);
  if constexpr (Rounding == rounding::ceiling) sum += unit - 1;
  return sum >> Point;
}

/// Returns `x` where `bad` is zero, else the end of the range of Raw with the sign of `sign`.
template <class Raw>
FIXED_LANE_FUNCTION i32 saturated(i32 x, i32 bad, i32 sign) {
  const i32 end = (sign >> 31) ^ std::int32_t{(std::numeric_limits<Raw>::max)()};
  return (x & ~bad) | (end & bad);
}

/// Wraps or saturates 32-bit sums in ulp to 16 bits.
template <overflow Overflow>
FIXED_LANE_FUNCTION i32 narrowed(i32 sum, i32& bad) {
  const i32 low = (sum << 16) >> 16;
  if constexpr (Overflow == overflow::wrap) {
    return low;
  } else {
    const i32 out = i32(low != sum);
    bad |= out;
    return Overflow == overflow::saturate ? saturated<std::int16_t>(low, out, sum) : low;
  }
}

/// Drops the last Point bits of biased sums, and wraps or saturates the rest to 32 bits.
template <overflow Overflow, int Point>
FIXED_LANE_FUNCTION i32 narrowed(wide_lanes sum, i32& bad) {
  const i32 low = middle<Point>(sum);
  if constexpr (Overflow == overflow::wrap) {
    return low;
  } else {
    // A sum is in range if all remaining upper bits equal the sign. With Point = 0 they are a word.
    const i32 high = upper_words(sum);
    const i32 out = i32((high >> (Point == 0 ? 0 : Point - 1)) != (low >> 31));
    bad |= out;
    return Overflow == overflow::saturate ? saturated<std::int32_t>(low, out, high) : low;
  }
}

/// Returns exact products in units of 2^-Point ulp: of 16-bit numbers in 32-bit lanes, of 32-bit
/// numbers in wide lanes.
template <class Number>
FIXED_LANE_FUNCTION auto exact_product(i32 a, i32 b) {
  if constexpr (sizeof(Number) == 2) {
    return a * b;
  } else {
    return products(a, b);
  }
}

/// Adds c to products.
/// @pre Point is at most the width of the stored integer less 2, so that the sums do not overflow
template <class Number>
FIXED_LANE_FUNCTION i32 exact_sum(i32 product, i32 c) {
  return product + (c << Number::fraction_bits);
}
template <class Number>
FIXED_LANE_FUNCTION wide_lanes exact_sum(wide_lanes product, i32 c) {
  const wide_lanes term = products_by(i32{} + (1 << Number::fraction_bits), c);
  return {product.first + term.first, product.second + term.second};
}

/// Rounds sums, and wraps or saturates them.
template <class Number>
FIXED_LANE_FUNCTION i32 rounded_product(i32 sum, i32& bad) {
  return narrowed<Number::rules.product_range()>(
      rounded<Number::rules.multiply, Number::fraction_bits>(sum), bad);
}
template <class Number>
FIXED_LANE_FUNCTION i32 rounded_product(wide_lanes sum, i32& bad) {
  constexpr int Point = Number::fraction_bits;
  constexpr rounding Rounding = Number::rules.multiply;
  return narrowed<Number::rules.product_range(), Point>(
      {biased<Rounding, Point>(sum.first), biased<Rounding, Point>(sum.second)}, bad);
}

template <class Number>
FIXED_LANE_FUNCTION i32 product(i32 a, i32 b, i32& bad) {
  return rounded_product<Number>(exact_product<Number>(a, b), bad);
}

/// @name Results whose range is checked later, for several blocks at once
///
/// These functions add half the range to the rounded sums. A sum in range is then not negative, and
/// its upper bits are clear. `sums` collects the bits of all sums. Flipping the sign bit of the
/// result takes the half range away again.
/// \{

/// Rounds sums, and wraps them to 16 bits. Only the lower halves of the lanes are valid.
template <class Number>
FIXED_LANE_FUNCTION i32 unchecked(i32 sum, u64& sums) {
  constexpr std::int32_t half_range = 1 << 15;
  sum = rounded<Number::rules.multiply, Number::fraction_bits>(sum) + half_range;
  sums |= u64(sum);
  return sum ^ half_range;
}

/// Rounds sums in wide lanes, and wraps them to 32 bits. All of each lane is valid.
template <class Number>
FIXED_LANE_FUNCTION i32 unchecked(wide_lanes sum, u64& sums) {
  constexpr int Point = Number::fraction_bits;
  constexpr rounding Rounding = Number::rules.multiply;
  constexpr std::uint64_t half_range = std::uint64_t{1} << (31 + Point);
  const u64 first = u64(biased<Rounding, Point>(sum.first)) + half_range;
  const u64 second = u64(biased<Rounding, Point>(sum.second)) + half_range;
  sums |= first | second;
  return middle<Point>({i64(first), i64(second)}) ^ (std::numeric_limits<std::int32_t>::min)();
}

/// Tells whether all results were in range. Always true under overflow::wrap.
template <class Number>
FIXED_LANE_FUNCTION bool in_range(u64 sums) {
  if constexpr (Number::rules.product_range() == overflow::wrap) {
    return true;
  } else if constexpr (sizeof(Number) == 2) {
    return !any_bit(u64(u32(sums) >> 16));
  } else if constexpr (Number::fraction_bits < 32) {
    return !any_bit(sums >> (32 + Number::fraction_bits));
  } else {
    return true;
  }
}

/// \}

template <class Number>
FIXED_LANE_FUNCTION i32 added(i32 a, i32 b, i32& bad) {
  constexpr overflow Overflow = Number::rules.range;
  if constexpr (sizeof(Number) == 2) {
    return narrowed<Overflow>(a + b, bad);
  } else {
    const i32 sum = i32(u32(a) + u32(b));
    if constexpr (Overflow == overflow::wrap) {
      return sum;
    } else {
      // A sum is out of range if its sign differs from the signs of both operands.
      const i32 out = ((a ^ sum) & (b ^ sum)) >> 31;
      bad |= out;
      return Overflow == overflow::saturate ? saturated<std::int32_t>(sum, out, a) : sum;
    }
  }
}

/// The part of a divisor that the policy uses, and the lanes with 0.
struct divisor_lanes {
  std::uint32_t zeros;
  half_i32 are_zero;
  half_i32 stored;  ///< 0 for 0
  f64 value;        ///< 1 for 0
};

/// The lesser of two integers in each lane, taken as unsigned.
FIXED_LANE_FUNCTION half_i32 lesser(half_i32 a, half_i32 b) {
  return half_i32(half_u32(a) < half_u32(b) ? half_u32(a) : half_u32(b));
}

/// What the policy divides by.
template <class Number>
FIXED_LANE_FUNCTION half_i32 used_part(half_i32 d) {
  constexpr int Point = Number::fraction_bits;
  if constexpr (Number::rules.divisor == divisor_width::whole_part) {
    d = (d + ((d >> 31) & ((1 << Point) - 1))) >> Point;
  }
  return d;
}

template <class Number>
FIXED_LANE_FUNCTION divisor_lanes divisor_of(half_i32 d) {
  d = used_part<Number>(d);
  const half_i32 are_zero = half_i32(d == 0);
  return {zero_bits(d), are_zero, d, doubles(d - are_zero)};
}

FIXED_LANE_FUNCTION f64 magnitude_of(f64 x) {
  return f64(i64(x) & (std::numeric_limits<std::int64_t>::max)());
}

FIXED_LANE_FUNCTION f64 with_sign_of(f64 magnitude, f64 sign) {
  return f64(i64(magnitude) | (i64(sign) & (std::numeric_limits<std::int64_t>::min)()));
}

/// The vector form of detail::quotient_sum(), which has the proof. The floor or trunc of the sum is
/// the rounded quotient.
template <rounding Rounding, int Shift>
FIXED_LANE_FUNCTION f64 sum_before_rounding(f64 numerator, f64 divisor) {
  constexpr double scale = std::int64_t{1} << Shift;
  // Scaling is exact. Where one instruction multiplies and adds (AVX-512, NEON), compilers fuse it
  // with the sum; clang++ does so only within an expression.
  const f64 q = numerator / divisor;
  if constexpr (Rounding == rounding::half_up) {
    return q * scale + 0.5;
  } else if constexpr (Rounding == rounding::half_away) {
    return q * scale + with_sign_of(f64{} + 0.5, q);
  } else {
    return q * scale;
  }
}

/// Returns half a block of quotients under the policy, with any value where the divisor is zero.
/// Sets a bit in `errors` for a divide error, and in `overflows` for a result that is only out of
/// range.
template <class Number>
FIXED_LANE_FUNCTION half_i32 quotient_if_any(half_i32 n, const divisor_lanes& d,
                                             std::uint32_t& errors, std::uint32_t& overflows) {
  using raw = typename Number::raw_type;
  constexpr policy Rules = Number::rules;
  constexpr overflow Overflow = Rules.quotient_range();
  constexpr int shift = numerator_shift<Number::fraction_bits, Rules>;
  constexpr bool by_floor = rounds_by_floor<Rules.divide>;
  constexpr double low = (std::numeric_limits<raw>::min)();
  constexpr double high = (std::numeric_limits<raw>::max)();
  const f64 numerator = doubles(n);
  f64 sum = sum_before_rounding<Rules.divide, shift>(numerator, d.value);

  errors = d.zeros;
  if constexpr (Rules.fault == divide_fault::unsigned_quotient) {
    // |n| 2^shift / |d| >= 2^bits. Both sides are exact.
    constexpr double units = std::int64_t{1} << (bits_of<raw> - shift);
    errors |= bits_at_least(magnitude_of(numerator), magnitude_of(d.value) * units);
  }
  overflows = 0;
  if constexpr (Rules.fault == divide_fault::signed_quotient || Overflow != overflow::wrap) {
    // Whether the floor or trunc of the sum is above `high` or below `low`.
    const std::uint32_t above = bits_at_least(sum, f64{} + (high + 1));
    const std::uint32_t below =
        by_floor ? bits_below(sum, f64{} + low) : bits_at_least(f64{} + (low - 1), sum);
    if constexpr (Rules.fault == divide_fault::signed_quotient) errors |= above | below;
    if constexpr (Overflow != overflow::wrap) overflows = (above | below) & ~errors;
  }
  if constexpr (Overflow == overflow::saturate) sum = clamp(sum, f64{} + low, f64{} + high);
  const half_i32 result = low_words(whole<by_floor>(sum));
  if constexpr (sizeof(raw) == 2) return (result << 16) >> 16;
  return result;
}

/// The same, with the results of the policy where the divisor is zero.
template <class Number>
FIXED_LANE_FUNCTION half_i32 quotient(half_i32 n, const divisor_lanes& d, std::uint32_t& errors,
                                      std::uint32_t& overflows) {
  using raw = typename Number::raw_type;
  half_i32 result = quotient_if_any<Number>(n, d, errors, overflows);
  if (d.zeros != 0) [[unlikely]] {
    const half_i32 end = ((n >> 31) ^ std::int32_t{(std::numeric_limits<raw>::max)()}) & (n != 0);
    result = (result & ~d.are_zero) | (end & d.are_zero);
  }
  return result;
}

/// Returns the nearest square roots in ulp. A negative operand gives 0 and adds a bit to `errors`.
///
/// The code takes the root of n = x 2^Point < 2^47 in single precision, and corrects it by the
/// remainder. Let R be the exact root, so R < 2^23.5, let s be the root in single precision, and
/// let r be s as an integer. Scaling by 2^Point is exact. Converting x has a relative error of at
/// most e. The root halves that error and adds e of its own. So s is off by less than 1.5 R e,
/// apart from a little for e^2. The nearest integer is within 1/2 of R, so r is off from it by at
/// most d if |r - R| + 1/2 < d + 1.
///
/// AVX-512 rounds to nearest in every mode of the processor, so e = 2^-24. If s >= 2^23, s is an
/// integer and |r - R| < 1.07. If 2^22 <= s < 2^23, |r - R| < 0.76 + 1/2. If s < 2^22,
/// |r - R| < 0.39 + 1/2. So r is off by at most 1. Without AVX-512 the mode decides, so e = 2^-23,
/// and s may be truncated. In the same three cases |r - R| is below 2.13, 1.51 + 1/2 and 0.76 + 1.
/// So r is off by at most 2.
///
/// The nearest integer is above r if n > (r + 1/2)^2 = r^2 + r + 1/4, that is, if the rest n - r^2
/// is above r. It is above r + 1 if the rest is above 3 r + 2. It is below r if the rest is below
/// 1 - r, and below r - 1 if the rest is below 3 - 3 r. The rest is below 2^27 in magnitude, so 32
/// bits hold it. Only n = 0 gives a wrong result, which is negative. The last line makes it 0.
template <int Point>
FIXED_LANE_FUNCTION i32 nearest_roots(i32 x, std::uint32_t& errors) {
  errors |= bits(x);
  constexpr float units = 1 << Point;
  x &= ~(x >> 31);
  const i32 r = integers(root(floats(x) * units));
  const i32 rest = i32((u32(x) << Point) - u32(r) * u32(r));
  // The sign of a difference tells which of two numbers is less.
  i32 nearest = r - ((r - rest) >> 31) + ((rest - 1 + r) >> 31);
  if constexpr (!has_nearest_floats) {
    const i32 three_r = r + r + r;
    nearest += ((rest - 3 + three_r) >> 31) - ((three_r + 2 - rest) >> 31);
  }
  return nearest & ~(nearest >> 31);
}

/// Records a fault for each bit of `lanes`.
FIXED_LANE_FUNCTION void note_lanes(fault what, std::uint32_t lanes, std::size_t index,
                                    fault_recorder& found) {
  if (lanes != 0) [[unlikely]] {
    found.note_bits(what, lanes, index);
  }
}

/// Records an overflow for each lane that is set in `bad` and whose bit is set in `of`. Does
/// nothing under overflow::wrap.
template <overflow Overflow>
FIXED_LANE_FUNCTION void note_overflows(i32 bad, std::size_t index, fault_recorder& found,
                                        std::uint32_t of = ~0U) {
  if constexpr (Overflow != overflow::wrap)
    note_lanes(fault::overflow, bits(bad) & of, index, found);
}

}  // namespace fixproof::detail::FIXED_LANES
#endif
