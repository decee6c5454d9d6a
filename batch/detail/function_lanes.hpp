/// \file
/// Estimates of functions in double, each with an error bound; see batch/detail/lanes.hpp.
///
/// If both ends of the range of an estimate round to the same integer, that integer is the
/// correctly rounded result, and the scalar function gives the same bits. The scalar function
/// computes all other lanes. So neither a rounding mode nor a fused operation can change a result.
/// Each bound is at least twice the error of the polynomial and of all roundings, in the least
/// exact rounding mode.
///
/// Operands are stored integers, and estimates are in ulps, for F fraction bits.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// The exact result is within `error` of `ulps`, except in the lanes of `unknown`.
struct flat_estimate {
  f64 ulps;
  double error;
  std::uint32_t unknown = 0;
};

/// The same, with an error of |ulps| * relative + error.
struct growing_estimate {
  f64 ulps;
  f64 relative;
  double error = 0;
  std::uint32_t unknown = 0;
};

// fused(a, b, c)      a * b + c, rounded once
// nearest_whole(x)    the nearest integer, in every rounding mode
// scaled(x, n)        x * 2^n for a whole n, if x and the result are from 2^-1000 to 2^1000, or in
//                     any range if scales_any
#if FIXED_LANE_BYTES == 64
FIXED_LANE_FUNCTION f64 fused(f64 a, f64 b, f64 c) { return _mm512_fmadd_pd(a, b, c); }
FIXED_LANE_FUNCTION f64 nearest_whole(f64 x) {
  return _mm512_maskz_roundscale_pd(0xff, x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
inline constexpr bool scales_any = true;
FIXED_LANE_FUNCTION f64 scaled(f64 x, f64 exponent) {
  return _mm512_maskz_scalef_pd(0xff, x, exponent);
}
#else
#if FIXED_LANE_BYTES == 32
FIXED_LANE_FUNCTION f64 fused(f64 a, f64 b, f64 c) { return _mm256_fmadd_pd(a, b, c); }
FIXED_LANE_FUNCTION f64 nearest_whole(f64 x) {
  return _mm256_round_pd(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}
#else
FIXED_LANE_FUNCTION f64 fused(f64 a, f64 b, f64 c) {
  return f64(vfmaq_f64(float64x2_t(c), float64x2_t(a), float64x2_t(b)));
}
FIXED_LANE_FUNCTION f64 nearest_whole(f64 x) { return f64(vrndnq_f64(float64x2_t(x))); }
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

/// Returns the sum of scale * terms[n] x^n. \param scale a power of two
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

/// Returns x * `factor`, where `factor` is a binary logarithm in two parts. Limits x to +-`limit`,
/// unless scaled() takes any exponent.
FIXED_LANE_FUNCTION exponent_lanes exponent_of(f64 x, const std::array<double, 2>& factor,
                                               double limit) {
  if (!scales_any) x = clamp(x, f64{} - limit, f64{} + limit);
  const f64 whole = nearest_whole(x * factor[0]);
  return {whole, fused(x, f64{} + factor[0], x * factor[1] - whole)};
}

/// Returns the exponent of 2 for e^x. Beyond 40, every power is out of range or rounds to a
/// constant.
template <int F>
FIXED_LANE_FUNCTION exponent_lanes exponent_of_e(f64 x) {
  return exponent_of(x, {two_log2_e[0] / one_in<F>, two_log2_e[1] / one_in<F>}, 40 * one_in<F>);
}

/// Returns scale * 2^exponent. The relative error is below 2^-44, or below 2^-33 if F <= 16.
/// \param scale a power of two
template <int F>
FIXED_LANE_FUNCTION f64 power_of_two(const exponent_lanes& exponent, double scale) {
  return scaled(
      polynomial(by_precision<F>(few_power_terms, many_power_terms), scale, exponent.rest),
      exponent.whole);
}
template <int F>
inline constexpr double power_error = by_precision<F>(0x1p-32, 0x1p-43);

/// Returns log2(x) for x > 2^-1000. The error is below 2^-44, or 2^-30 if F <= 16, plus
/// |log2(x)| 2^-51.
template <int F>
FIXED_LANE_FUNCTION f64 binary_logarithm(f64 x) {
  // sqrt(1/2). A mantissa is from there to twice that.
  constexpr std::uint64_t lowest = 0x3fe6a09e667f3bcd;
  constexpr std::uint64_t one = 0x3ff0000000000000;
  constexpr std::uint64_t integer_bits = 0x4330000000000000;  // 2^52
  const u64 exponent = (u64(x) + (one - lowest)) >> 52;
  const f64 mantissa = f64(u64(x) - (exponent << 52) + one);
  const f64 s = (mantissa - 1) / (mantissa + 1);
  const f64 whole = f64(exponent + integer_bits) - (0x1p52 + 1023);
  return fused(s, polynomial(by_precision<F>(few_logarithm_terms, many_logarithm_terms), 1, s * s),
               whole);
}
template <int F>
inline constexpr double logarithm_error = by_precision<F>(0x1p-29, 0x1p-43);

/// Returns scale * sin(pi t) for |t| <= 1/2. The error is below scale * 2^-48, or scale * 2^-33 if
/// F <= 16.
template <int F>
FIXED_LANE_FUNCTION f64 sine_of_half_turns(f64 t, double scale) {
  return t * polynomial(by_precision<F>(few_sine_terms, many_sine_terms), scale, t * t);
}
template <int F>
inline constexpr double sine_error = by_precision<F>(0x1p-32, 0x1p-46);

/// Returns the angle of the vector (d, n) in ulps, for d, n >= 0. The error is below 2^-44 radians,
/// or 2^-31 if F <= 16.
///
/// Mirrors a steep vector at the diagonal. Then turns the vector back by pi/4 if n / d is above
/// tan(pi/8).
template <int F>
FIXED_LANE_FUNCTION f64 angle_of(f64 n, f64 d) {
  constexpr double eighth = 0x1.a827999fcef32p-2;  // tan(pi/8)
  constexpr double quarter = double_pi / 4 * one_in<F>;
  const i64 is_steep = n > d;
  const f64 low = is_steep ? d : n;
  const f64 high = is_steep ? n : d;
  const i64 is_far = low > high * eighth;
  const f64 z = (is_far ? low - high : low) / (is_far ? low + high : high);
  const f64 angle = fused(
      z, polynomial(by_precision<F>(few_arctangent_terms, many_arctangent_terms), one_in<F>, z * z),
      is_far ? f64{} + quarter : f64{});
  return is_steep ? 2 * quarter - angle : angle;
}
template <int F>
inline constexpr double angle_error = by_precision<F>(0x1p-30, 0x1p-43) * one_in<F>;

template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_exp2, f64 x) {
  const exponent_lanes exponent = exponent_of(x, {1 / one_in<F>, 0}, 40 * one_in<F>);
  return {power_of_two<precise>(exponent, one_in<F>), f64{} + power_error<precise>};
}

template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_exp, f64 x) {
  return {power_of_two<precise>(exponent_of_e<F>(x), one_in<F>), f64{} + power_error<precise>};
}

template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_expm1, f64 x) {
  return {power_of_two<precise>(exponent_of_e<F>(x), one_in<F>) - one_in<F>,
          f64{} + power_error<precise>, power_error<precise> * one_in<F>};
}

/// Returns a logarithm of x / 2^F. \param base the logarithm of 2 in its base
template <int F>
FIXED_LANE_FUNCTION flat_estimate logarithm(f64 x, double base) {
  return {(binary_logarithm<F>(x) - F) * (base * one_in<F>), logarithm_error<F> * one_in<F>,
          bits_below(x, f64{} + 1)};
}
template <int F>
FIXED_LANE_FUNCTION flat_estimate estimated(of_log2, f64 x) {
  return logarithm<F>(x, 1);
}
template <int F>
FIXED_LANE_FUNCTION flat_estimate estimated(of_log, f64 x) {
  return logarithm<F>(x, log_2);
}
template <int F>
FIXED_LANE_FUNCTION flat_estimate estimated(of_log10, f64 x) {
  return logarithm<F>(x, log10_2);
}
template <int F>
FIXED_LANE_FUNCTION flat_estimate estimated(of_log1p, f64 x) {
  return logarithm<F>(x + one_in<F>, log_2);
}

/// e^x / 2 and e^-x / 2.
struct hyperbola_lanes {
  f64 rising;
  f64 falling;
};
template <int F>
FIXED_LANE_FUNCTION hyperbola_lanes hyperbola_of(f64 x) {
  const exponent_lanes exponent = exponent_of_e<F>(x);
  return {power_of_two<precise>(exponent, one_in<F> / 2),
          power_of_two<precise>({-exponent.whole, -exponent.rest}, one_in<F> / 2)};
}
template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_sinh, f64 x) {
  const hyperbola_lanes h = hyperbola_of<F>(x);
  return {h.rising - h.falling, f64{} + power_error<precise>, power_error<precise> * one_in<F>};
}
template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_cosh, f64 x) {
  const hyperbola_lanes h = hyperbola_of<F>(x);
  return {h.rising + h.falling, f64{} + power_error<precise>};
}

/// Returns (t - 1) / (t + 1) for t = e^2x. Beyond 20, the result is constant.
template <int F>
FIXED_LANE_FUNCTION flat_estimate estimated(of_tanh, f64 x) {
  x = clamp(x * 2, f64{} - 40 * one_in<F>, f64{} + 40 * one_in<F>);
  const f64 power = power_of_two<F>(exponent_of_e<F>(x), 1);
  return {(power - 1) * one_in<F> / (power + 1), power_error<F> * one_in<F>};
}

/// An angle in half turns: `whole` + t, with |t| <= 1/2.
struct angle_lanes {
  f64 whole;
  f64 t;
};

/// Returns the angle of x, advanced by `ahead` half turns, for |x| < 2^33. The error of t is below
/// 2^-52.
template <int F, angle_unit Unit>
FIXED_LANE_FUNCTION angle_lanes half_turns(f64 x, double ahead) {
  constexpr double high = half_turns_per<Unit>[0] / one_in<F>;
  constexpr double low = half_turns_per<Unit>[1] / one_in<F>;
  const f64 whole = nearest_whole(fused(x, f64{} + high, f64{} + ahead));
  return {whole, fused(x, f64{} + low, fused(x, f64{} + high, ahead - whole))};
}

template <int F>
FIXED_LANE_FUNCTION flat_estimate sine(const angle_lanes& angle) {
  // The last bit of the whole number, which is set if it is odd, becomes the sign.
  const f64 sign = f64(i64(angle.whole + 0x1.8p52) << 63);
  return {signed_as(sine_of_half_turns<F>(angle.t, one_in<F>), sign), sine_error<F> * one_in<F>};
}
template <int F, angle_unit Unit>
FIXED_LANE_FUNCTION flat_estimate estimated(of_sine<Unit>, f64 x) {
  return sine<F>(half_turns<F, Unit>(x, 0));
}
template <int F, angle_unit Unit>
FIXED_LANE_FUNCTION flat_estimate estimated(of_cosine<Unit>, f64 x) {
  return sine<F>(half_turns<F, Unit>(x, 0.5));
}

/// A sine divided by a cosine. An error e of both makes an error below e (1 + tangent)^2, which is
/// at most 2 e + 2 e tangent^2.
template <int F, angle_unit Unit>
FIXED_LANE_FUNCTION growing_estimate estimated(of_tangent<Unit>, f64 x) {
  constexpr double error = 2 * sine_error<precise>;
  const angle_lanes angle = half_turns<F, Unit>(x, 0);
  const f64 cosine = sine_of_half_turns<precise>(0.5 - magnitude(angle.t), 1);
  const f64 ulps = sine_of_half_turns<precise>(angle.t, one_in<F>) / cosine;
  return {ulps, magnitude(ulps) * (error / one_in<F>), error * one_in<F>,
          bits_below(cosine, f64{} + 0x1p-36)};
}

template <int F>
FIXED_LANE_FUNCTION flat_estimate estimated(of_atan, f64 x) {
  return {signed_as(angle_of<F>(magnitude(x), f64{} + one_in<F>), x), angle_error<F>};
}

template <int F>
FIXED_LANE_FUNCTION flat_estimate estimated(of_atan2, f64 y, f64 x) {
  const f64 angle = angle_of<F>(magnitude(y), magnitude(x));
  return {signed_as(x < 0 ? double_pi * one_in<F> - angle : angle, y), angle_error<F>,
          bits_below(magnitude(x) + magnitude(y), f64{} + 1)};
}

/// Returns the other side of a right triangle whose longest side is 2^F. The result is meaningless
/// for a longer x.
template <int F>
FIXED_LANE_FUNCTION f64 side_of(f64 x) {
  return root((one_in<F> - x) * (one_in<F> + x));
}

template <int F>
FIXED_LANE_FUNCTION flat_estimate estimated(of_asin, f64 x) {
  return {signed_as(angle_of<F>(magnitude(x), side_of<F>(x)), x), angle_error<F>,
          bits_below(f64{} + one_in<F>, magnitude(x))};
}

template <int F>
FIXED_LANE_FUNCTION flat_estimate estimated(of_acos, f64 x) {
  const f64 angle = angle_of<F>(side_of<F>(x), magnitude(x));
  return {x < 0 ? double_pi * one_in<F> - angle : angle, angle_error<F>,
          bits_below(f64{} + one_in<F>, magnitude(x))};
}

template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_cbrt, f64 x) {
  constexpr double third = 1.0 / 3;
  const f64 size = magnitude(x);
  const f64 exponent = fused(binary_logarithm<F>(size), f64{} + third, f64{} - F * third);
  const f64 whole = nearest_whole(exponent);
  const f64 power = power_of_two<F>({whole, exponent - whole}, one_in<F>);
  return {signed_as(power, x), f64{} + 2 * power_error<F>, 0, bits_below(size, f64{} + 1)};
}

/// The relative error of a few roundings.
inline constexpr double root_error = 0x1p-49;

template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_rsqrt, f64 x) {
  return {one_in<F> / root(x * (1 / one_in<F>)), f64{} + root_error, 0, bits_below(x, f64{} + 1)};
}

template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_reciprocal, f64 x) {
  return {one_in<F> * one_in<F> / x, f64{} + root_error, 0, bits_below(magnitude(x), f64{} + 1)};
}

template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_hypot, f64 x, f64 y) {
  return {root(fused(x, x, y * y)), f64{} + root_error};
}

/// Estimates only powers of positive numbers. An error e of the logarithm makes an error |y| e of
/// the exponent.
template <int F>
FIXED_LANE_FUNCTION growing_estimate estimated(of_pow, f64 x, f64 y) {
  y *= 1 / one_in<F>;
  const f64 exponent = clamp((binary_logarithm<precise>(x) - F) * y, f64{} - 40, f64{} + 40);
  const f64 whole = nearest_whole(exponent);
  return {power_of_two<precise>({whole, exponent - whole}, one_in<F>),
          (magnitude(y) + 1) * power_error<precise>, 0, bits_below(x, f64{} + 1)};
}

/// Returns the lanes in which an estimate, at `distance` from the nearest integer, allows two
/// results.
FIXED_LANE_FUNCTION std::uint32_t undecided(const flat_estimate& x, f64 /*ulps*/, f64 distance) {
  return bits_below(f64{} + (0.5 - x.error), distance);
}
FIXED_LANE_FUNCTION std::uint32_t undecided(const growing_estimate& x, f64 ulps, f64 distance) {
  return bits_below((0.5 - x.error) - magnitude(ulps) * x.relative, distance);
}

/// The functions as a type, which on_function_path() passes to its callable.
struct functions {
  /// Rounds an estimate, and finds the lanes that it does not decide. Results out of range
  /// saturate, or are unknown under overflow::trap.
  template <class N, class Function, class Estimate>
  FIXED_LANE_FUNCTION static half_i32 rounded(const Estimate& x, std::uint32_t& unknown) {
    using limits = std::numeric_limits<typename N::raw_type>;
    constexpr double lowest = (limits::min)();
    constexpr double highest = (limits::max)();
    unknown = x.unknown;
    f64 ulps = x.ulps;
    if constexpr (Function::limit * one_in < N::fraction_bits >> highest) {
      if constexpr (N::rules.range == overflow::trap) {
        unknown |= bits_below(ulps, f64{} + lowest) | bits_below(f64{} + highest, ulps);
      }
      ulps = clamp(ulps, f64{} + lowest, f64{} + highest);
    }
    const f64 whole = nearest_whole(ulps);
    unknown |= undecided(x, ulps, magnitude(ulps - whole));
    return __builtin_convertvector(whole, half_i32);
  }

  /// Computes out[i] = scalar(from[i]...), as many as fill whole registers.
  /// \return the number of elements done
  template <class N, class Function, class Scalar, class... Operands>
  FIXED_LANE_TARGET static std::size_t each(N* out, std::size_t count, const Scalar& scalar,
                                            Operands... from) noexcept(N::never_throws) {
    using raw = typename N::raw_type;
    constexpr std::size_t half = width / 2;
    std::size_t i = 0;
    for (; count - i >= half; i += half) {
      std::uint32_t unknown = 0;
      half_i32 result = rounded<N, Function>(
          estimated<N::fraction_bits>(Function{}, doubles(load_half<raw>(from, i))...), unknown);
      for (; unknown != 0; unknown &= unknown - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(unknown));
        result[lane] = scalar(from[i + lane]...).raw();
      }
      store_half<raw>(out, i, result);
    }
    return i;
  }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
