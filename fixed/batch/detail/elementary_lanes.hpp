/// @file
/// Powers, logarithms and angles in double. fixed/batch/detail/function_lanes.hpp makes the
/// functions from them; see fixed/batch/detail/lanes.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

// fused(a, b, c)      a * b + c, rounded once
// nearest_whole(x)    the nearest integer, in every rounding mode
// scaled(x, n)        x * 2^n for a whole n, if x and the result are from 2^-1000 to 2^1000, or in
//                     any range if scales_any
// words(x)            converts whole numbers of 32 bits. Any other x, even a NaN, gives any word,
//                     while __builtin_convertvector() is undefined for it
#if FIXED_LANE_BYTES == 64
FIXED_LANE_FUNCTION f64 fused(f64 a, f64 b, f64 c) { return _mm512_fmadd_pd(a, b, c); }
FIXED_LANE_FUNCTION f64 nearest_whole(f64 x) {
  return _mm512_maskz_roundscale_pd(0xff, x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
inline constexpr bool scales_any = true;
FIXED_LANE_FUNCTION f64 scaled(f64 x, f64 exponent) {
  return _mm512_maskz_scalef_pd(0xff, x, exponent);
}
FIXED_LANE_FUNCTION half_i32 words(f64 x) { return half_i32(_mm512_maskz_cvtpd_epi32(0xff, x)); }
#else
#if FIXED_LANE_BYTES == 32
FIXED_LANE_FUNCTION f64 fused(f64 a, f64 b, f64 c) { return _mm256_fmadd_pd(a, b, c); }
FIXED_LANE_FUNCTION f64 nearest_whole(f64 x) {
  return _mm256_round_pd(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
FIXED_LANE_FUNCTION half_i32 words(f64 x) { return half_i32(_mm256_cvtpd_epi32(x)); }
#else
FIXED_LANE_FUNCTION f64 fused(f64 a, f64 b, f64 c) {
  return f64(vfmaq_f64(float64x2_t(c), float64x2_t(a), float64x2_t(b)));
}
FIXED_LANE_FUNCTION f64 nearest_whole(f64 x) { return f64(vrndnq_f64(float64x2_t(x))); }
FIXED_LANE_FUNCTION half_i32 words(f64 x) { return low_words(i64(vcvtq_s64_f64(float64x2_t(x)))); }
#endif
inline constexpr bool scales_any = false;
FIXED_LANE_FUNCTION f64 scaled(f64 x, f64 exponent) {
  constexpr double integer_bits = 0x1.8p52;  // the last bit of a sum with it has weight one
  return f64(i64(x) + (i64(exponent + integer_bits) << 52));
}
#endif

FIXED_LANE_FUNCTION f64 magnitude(f64 x) {
  constexpr std::int64_t all_but_sign = (std::numeric_limits<std::int64_t>::max)();
  return f64(i64(x) & all_but_sign);
}

/// Returns x, negated where `sign` is negative.
FIXED_LANE_FUNCTION f64 signed_as(f64 x, f64 sign) {
  constexpr std::int64_t sign_bit = (std::numeric_limits<std::int64_t>::min)();
  return f64(i64(x) ^ (i64(sign) & sign_bit));
}

/// Returns the sum of scale * terms[n] x^n. @param scale a power of two
template <std::size_t n = 0, std::size_t size>
FIXED_LANE_FUNCTION f64 polynomial(const std::array<double, size>& terms, double scale, f64 x) {
  if constexpr (n + 1 == size) {
    return f64{} + terms[n] * scale;
  } else {
    return fused(polynomial<n + 1>(terms, scale, x), x, f64{} + terms[n] * scale);
  }
}

/// Selects the precise polynomials, for estimates with a relative error, whose results may have 31
/// bits.
inline constexpr int precise = 32;

/// A power of two as 2^whole * 2^rest, |rest| <= 1/2.
struct exponent_lanes {
  f64 whole;
  f64 rest;
};

/// Returns the operand of an exponential, limited if scaled() needs that. Beyond 40, every power is
/// out of range or rounds to a constant.
template <int Point>
FIXED_LANE_FUNCTION f64 limited(f64 x) {
  return scales_any ? x : clamp(x, f64{} - 40 * one_in<Point>, f64{} + 40 * one_in<Point>);
}

/// Returns the exponent of 2 for e^x.
template <int Point>
FIXED_LANE_FUNCTION exponent_lanes exponent_of_e(f64 x) {
  constexpr double high = two_log2_e[0] / one_in<Point>;
  constexpr double low = two_log2_e[1] / one_in<Point>;
  x = limited<Point>(x);
  const f64 whole = nearest_whole(x * high);
  return {whole, fused(x, f64{} + high, x * low - whole)};
}

/// Returns scale * 2^exponent. The relative error is below 2^-44, or below 2^-33 if Point <= 16.
/// @param scale a power of two
template <int Point>
FIXED_LANE_FUNCTION f64 power_of_two(const exponent_lanes& exponent, double scale) {
  return scaled(
      polynomial(by_precision<Point>(few_power_terms, many_power_terms), scale, exponent.rest),
      exponent.whole);
}
template <int Point>
inline constexpr double power_error = by_precision<Point>(0x1p-32, 0x1p-43);

/// Every second term, from the first or from the second.
template <std::size_t first, std::size_t size>
constexpr std::array<double, size / 2> alternate(const std::array<double, size>& terms) {
  static_assert(size % 2 == 0);
  std::array<double, size / 2> result{};
  for (std::size_t i = 0; i < size / 2; ++i) result[i] = terms[first + 2 * i];
  return result;
}

/// e^x / 2 and e^-x / 2.
struct hyperbola_lanes {
  f64 rising;
  f64 falling;
};
/// The polynomials of 2^r and 2^-r differ only in the sign of their odd terms. The relative errors
/// are those of power_of_two<precise>().
template <int Point>
FIXED_LANE_FUNCTION hyperbola_lanes hyperbola_of(f64 x) {
  const auto [whole, rest] = exponent_of_e<Point>(x);
  const f64 square = rest * rest;
  const f64 even = polynomial(alternate<0>(many_power_terms), one_in<Point> / 2, square);
  const f64 odd = rest * polynomial(alternate<1>(many_power_terms), one_in<Point> / 2, square);
  return {scaled(even + odd, whole), scaled(even - odd, -whole)};
}

/// Returns log2(x) for x > 2^-1000. The error is below 2^-44, or 2^-30 if Point <= 16, plus
/// |log2(x)| 2^-51.
template <int Point>
FIXED_LANE_FUNCTION f64 binary_logarithm(f64 x) {
  // sqrt(1/2). A mantissa is from there to twice that.
  constexpr std::uint64_t lowest = 0x3fe6a09e667f3bcd;
  constexpr std::uint64_t one = 0x3ff0000000000000;
  constexpr std::uint64_t integer_bits = 0x4330000000000000;  // 2^52
  const u64 exponent = (u64(x) + (one - lowest)) >> 52;
  const f64 mantissa = f64(u64(x) - (exponent << 52) + one);
  const f64 s = (mantissa - 1) / (mantissa + 1);
  const f64 whole = f64(exponent + integer_bits) - (0x1p52 + 1023);
  return fused(s,
               polynomial(by_precision<Point>(few_logarithm_terms, many_logarithm_terms), 1, s * s),
               whole);
}
template <int Point>
inline constexpr double logarithm_error = by_precision<Point>(0x1p-29, 0x1p-43);

/// An angle in half turns: `whole` + t, with |t| <= 1/2.
struct angle_lanes {
  f64 whole;
  f64 t;
};

/// Returns the angle of x, advanced by `ahead` half turns, for |x| < 2^33. The error of t is below
/// 2^-52.
template <int Point, angle_unit Unit>
FIXED_LANE_FUNCTION angle_lanes half_turns(f64 x, double ahead) {
  constexpr double high = half_turns_per<Unit>[0] / one_in<Point>;
  constexpr double low = half_turns_per<Unit>[1] / one_in<Point>;
  const f64 whole = nearest_whole(fused(x, f64{} + high, f64{} + ahead));
  return {whole, fused(x, f64{} + low, fused(x, f64{} + high, ahead - whole))};
}

/// Returns scale * sin(pi t) for |t| <= 1/2. The error is below scale * 2^-48, or scale * 2^-33 if
/// Point <= 16.
template <int Point>
FIXED_LANE_FUNCTION f64 sine_of_half_turns(f64 t, double scale) {
  return t * polynomial(by_precision<Point>(few_sine_terms, many_sine_terms), scale, t * t);
}
template <int Point>
inline constexpr double sine_error = by_precision<Point>(0x1p-32, 0x1p-46);

/// Returns the angle of the vector (d, n) in ulps, for d, n >= 0. The error is below 2^-44 radians,
/// or 2^-31 if Point <= 16.
///
/// Mirrors a steep vector at the diagonal. Then turns the vector back by pi/4 if n / d is above
/// tan(pi/8).
template <int Point>
FIXED_LANE_FUNCTION f64 angle_of(f64 n, f64 d) {
  constexpr double eighth = 0x1.a827999fcef32p-2;  // tan(pi/8)
  constexpr double quarter = double_pi / 4 * one_in<Point>;
  const i64 is_steep = n > d;
  const f64 low = is_steep ? d : n;
  const f64 high = is_steep ? n : d;
  const i64 is_far = low > high * eighth;
  const f64 z = (is_far ? low - high : low) / (is_far ? low + high : high);
  const f64 angle =
      fused(z,
            polynomial(by_precision<Point>(few_arctangent_terms, many_arctangent_terms),
                       one_in<Point>, z * z),
            is_far ? f64{} + quarter : f64{});
  return is_steep ? 2 * quarter - angle : angle;
}
template <int Point>
inline constexpr double angle_error = by_precision<Point>(0x1p-30, 0x1p-43) * one_in<Point>;

}  // namespace fixproof::detail::FIXED_LANES
#endif
