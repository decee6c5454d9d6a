/// \file
/// The rules of fixed/policy.hpp on blocks of numbers; see fixed/detail/batch_lanes.hpp.
///
/// Each lane of `bad` is set to ones if its result is out of range and is unchanged otherwise. The
/// bits of `errors` and `overflows` are assigned: one for each lane that has no result, or one out
/// of range.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// Adds detail::bias() to 64-bit sums of 2^-32 whose last 16 bits will be dropped.
template <rounding R>
FIXED_LANE_FUNCTION i64 biased(i64 sum) {
  constexpr std::int64_t unit = 1 << 16;
  if constexpr (R == rounding::half_up) {
    return sum + unit / 2;
  } else if constexpr (R == rounding::half_away) {
    return sum + unit / 2 + negative(sum);
  } else if constexpr (R == rounding::truncate) {
    return sum + (negative(sum) & (unit - 1));
  } else {
    static_assert(R == rounding::floor);
    return sum;
  }
}

/// Rounds 32-bit sums of 2^-16 by dropping their last 8 bits.
template <rounding R>
FIXED_LANE_FUNCTION i32 rounded_8(i32 sum) {
  constexpr std::int32_t unit = 1 << 8;
  if constexpr (R == rounding::half_up) sum += unit / 2;
  if constexpr (R == rounding::half_away) sum += unit / 2 + (sum >> 31);
  if constexpr (R == rounding::truncate) sum += (sum >> 31) & (unit - 1);
  return sum >> 8;
}

/// `x` if `bad` is zero, else the end of the range of F with the sign of `sign`.
template <int F>
FIXED_LANE_FUNCTION i32 saturated(i32 x, i32 bad, i32 sign) {
  const i32 end = (sign >> 31) ^ std::int32_t{(std::numeric_limits<raw_t<F>>::max)()};
  return (x & ~bad) | (end & bad);
}

/// Wraps or saturates 32-bit sums in ulp to the range of 8.8.
template <policy P>
FIXED_LANE_FUNCTION i32 narrowed_8(i32 sum, i32& bad) {
  const i32 low = (sum << 16) >> 16;
  if constexpr (P.range == overflow::wrap) {
    return low;
  } else {
    const i32 out = i32(low != sum);
    bad |= out;
    return P.range == overflow::saturate ? saturated<8>(low, out, sum) : low;
  }
}

/// Wraps or saturates biased sums of 2^-32, in even and odd lanes, to the range of 16.16.
template <policy P>
FIXED_LANE_FUNCTION i32 narrowed_16(i64 even, i64 odd, i32& bad) {
  const i32 low = middle(even, odd);
  if constexpr (P.range == overflow::wrap) {
    return low;
  } else {
    // In range if the upper 17 of the remaining 48 bits all equal the sign.
    const i32 high = interleaved(u64(even) >> 32, u64(odd));
    const i32 out = i32((high >> 15) != (low >> 31));
    bad |= out;
    return P.range == overflow::saturate ? saturated<16>(low, out, high) : low;
  }
}

FIXED_LANE_FUNCTION i64 odd_lanes(i32 x) { return i64(u64(x) >> 32); }

template <int F, policy P>
FIXED_LANE_FUNCTION i32 product(i32 a, i32 b, i32& bad) {
  if constexpr (F == 8) {
    return narrowed_8<P>(rounded_8<P.multiply>(a * b), bad);
  } else {
    return narrowed_16<P>(biased<P.multiply>(mul_even(i64(a), i64(b))),
                          biased<P.multiply>(mul_even(odd_lanes(a), odd_lanes(b))), bad);
  }
}

template <int F, policy P>
FIXED_LANE_FUNCTION i32 product_and_sum(i32 a, i32 b, i32 c, i32& bad) {
  if constexpr (F == 8) {
    return narrowed_8<P>(rounded_8<P.multiply>(a * b + (c << 8)), bad);
  } else {
    const i64 one = i64{} + (1 << 16);
    const i64 even = mul_even(i64(a), i64(b)) + mul_even(i64(c), one);
    const i64 odd = mul_even(odd_lanes(a), odd_lanes(b)) + mul_even(odd_lanes(c), one);
    return narrowed_16<P>(biased<P.multiply>(even), biased<P.multiply>(odd), bad);
  }
}

template <int F, policy P>
FIXED_LANE_FUNCTION i32 added(i32 a, i32 b, i32& bad) {
  if constexpr (F == 8) {
    return narrowed_8<P>(a + b, bad);
  } else {
    const i32 sum = i32(u32(a) + u32(b));
    if constexpr (P.range == overflow::wrap) {
      return sum;
    } else {
      // Out of range if the sign of the sum differs from the signs of both operands.
      const i32 out = ((a ^ sum) & (b ^ sum)) >> 31;
      bad |= out;
      return P.range == overflow::saturate ? saturated<16>(sum, out, a) : sum;
    }
  }
}

/// The part of a divisor that the policy uses, with 1 in place of 0.
struct divisor_lanes {
  std::uint32_t zeros;
  f64 value;
};

template <int F, policy P>
FIXED_LANE_FUNCTION divisor_lanes divisor_of(half_i32 d) {
  if constexpr (P.divisor == divisor_width::whole_part) {
    d = (d + ((d >> 31) & ((1 << F) - 1))) >> F;
  }
  return {zero_bits(d), doubles(d - (d == 0))};
}

FIXED_LANE_FUNCTION f64 magnitude_of(f64 x) {
  return f64(i64(x) & (std::numeric_limits<std::int64_t>::max)());
}

FIXED_LANE_FUNCTION f64 with_sign_of(f64 magnitude, f64 sign) {
  return f64(i64(magnitude) | (i64(sign) & (std::numeric_limits<std::int64_t>::min)()));
}

/// The vector form of detail::quotient_sum(), which has the proof; its floor or trunc is the
/// rounded quotient.
template <rounding R, int Shift>
FIXED_LANE_FUNCTION f64 sum_before_rounding(f64 numerator, f64 divisor) {
  constexpr double scale = std::int64_t{1} << Shift;
  const f64 q = numerator * scale / divisor;
  if constexpr (R == rounding::half_up) {
    return q + 0.5;
  } else if constexpr (R == rounding::half_away) {
    return q + with_sign_of(f64{} + 0.5, q);
  } else {
    return q;
  }
}

/// Half a block of quotients under the policy. Sets a bit in `errors` for a divide error and in
/// `overflows` for a result that is only out of range.
template <int F, policy P>
FIXED_LANE_FUNCTION half_i32 quotient(half_i32 n, const divisor_lanes& d, std::uint32_t& errors,
                                      std::uint32_t& overflows) {
  constexpr int shift = numerator_shift<F, P>;
  constexpr bool by_floor = rounds_by_floor<P.divide>;
  constexpr double low = (std::numeric_limits<raw_t<F>>::min)();
  constexpr double high = (std::numeric_limits<raw_t<F>>::max)();
  const f64 numerator = doubles(n);
  f64 sum = sum_before_rounding<P.divide, shift>(numerator, d.value);

  errors = d.zeros;
  if constexpr (P.fault == divide_fault::unsigned_quotient) {
    // |n| 2^shift / |d| >= 2^(2 F); both sides are exact.
    constexpr double units = std::int64_t{1} << (2 * F - shift);
    errors |= bits_at_least(magnitude_of(numerator), magnitude_of(d.value) * units);
  }
  overflows = 0;
  if constexpr (P.fault == divide_fault::signed_quotient || P.range != overflow::wrap) {
    // Whether the floor or trunc of the sum will be above `high` or below `low`.
    const std::uint32_t above = bits_at_least(sum, f64{} + (high + 1));
    const std::uint32_t below =
        by_floor ? bits_below(sum, f64{} + low) : bits_at_least(f64{} + (low - 1), sum);
    if constexpr (P.fault == divide_fault::signed_quotient) errors |= above | below;
    if constexpr (P.range != overflow::wrap) overflows = (above | below) & ~errors;
  }
  if constexpr (P.range == overflow::saturate) sum = clamp(sum, f64{} + low, f64{} + high);
  half_i32 result = low_words(whole<by_floor>(sum));
  if constexpr (F == 8) result = (result << 16) >> 16;
  if (d.zeros != 0) [[unlikely]] {
    for (std::size_t i = 0; i < width / 2; ++i) {
      if ((d.zeros >> i & 1U) != 0) {
        result[i] = limit_toward_zero<raw_t<F>>(static_cast<raw_t<F>>(n[i]));
      }
    }
  }
  return result;
}

/// The nearest square roots. A negative operand gives 0 and a bit in `errors`.
///
/// The hardware root of n = x 2^F < 2^47 is off by less than 2^-29 in every rounding mode, and
/// adding a half by as much again: 2^-28 together. Every root is more than 1 / (8 r + 4) > 2^-27
/// away from a half r + 1/2 (see detail::nearest_sqrt), so truncating the sum gives the nearest
/// integer.
template <int F>
FIXED_LANE_FUNCTION half_i32 nearest_root(half_i32 x, std::uint32_t& errors) {
  errors = bits(x);
  constexpr double units = 1 << F;
  const f64 n = doubles(x & ~(x >> 31)) * units;
  return low_words(whole<false>(root(n) + 0.5));
}

/// Records the lanes set in `bad` whose bit is in `of`. Does nothing under overflow::wrap.
template <policy P>
FIXED_LANE_FUNCTION void note_overflows(i32 bad, std::size_t index, fault_recorder& found,
                                        std::uint32_t of = ~0U) {
  if constexpr (P.range != overflow::wrap) {
    const std::uint32_t out = bits(bad) & of;
    if (out != 0) [[unlikely]] {
      found.note_bits(fault::overflow, out, index);
    }
  }
}

}  // namespace fixproof::detail::FIXED_LANES
#endif
