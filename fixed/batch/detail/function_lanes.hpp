/// @file
/// Estimates of functions in double, each with an error bound; see fixed/batch/detail/lanes.hpp.
///
/// If both ends of the range of an estimate round to the same integer, that integer is the
/// correctly rounded result, and the scalar function gives the same bits. The scalar function
/// computes all other lanes. So neither a rounding mode nor a fused operation can change a result.
/// Each bound is at least twice the error of the polynomial and of all roundings, in the least
/// exact rounding mode.
///
/// Operands are stored integers, and estimates are in ulps, for Point fraction bits.

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

template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_exp2, f64 x) {
  x = limited<Point>(x);
  const f64 exponent = x * (1 / one_in<Point>);
  const f64 whole = nearest_whole(exponent);
  return {power_of_two<precise>({whole, exponent - whole}, one_in<Point>),
          f64{} + power_error<precise>};
}

template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_exp, f64 x) {
  return {power_of_two<precise>(exponent_of_e<Point>(x), one_in<Point>),
          f64{} + power_error<precise>};
}

template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_expm1, f64 x) {
  return {power_of_two<precise>(exponent_of_e<Point>(x), one_in<Point>) - one_in<Point>,
          f64{} + power_error<precise>, power_error<precise> * one_in<Point>};
}

/// Returns a logarithm of x / 2^Point. @param base the logarithm of 2 in its base
template <int Point>
FIXED_LANE_FUNCTION flat_estimate logarithm(f64 x, double base) {
  return {(binary_logarithm<Point>(x) - Point) * (base * one_in<Point>),
          logarithm_error<Point> * one_in<Point>, bits_below(x, f64{} + 1)};
}
template <int Point>
FIXED_LANE_FUNCTION flat_estimate estimated(of_log2, f64 x) {
  return logarithm<Point>(x, 1);
}
template <int Point>
FIXED_LANE_FUNCTION flat_estimate estimated(of_log, f64 x) {
  return logarithm<Point>(x, log_2);
}
template <int Point>
FIXED_LANE_FUNCTION flat_estimate estimated(of_log10, f64 x) {
  return logarithm<Point>(x, log10_2);
}
template <int Point>
FIXED_LANE_FUNCTION flat_estimate estimated(of_log1p, f64 x) {
  return logarithm<Point>(x + one_in<Point>, log_2);
}

template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_sinh, f64 x) {
  const hyperbola_lanes h = hyperbola_of<Point>(x);
  return {h.rising - h.falling, f64{} + power_error<precise>, power_error<precise> * one_in<Point>};
}
template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_cosh, f64 x) {
  const hyperbola_lanes h = hyperbola_of<Point>(x);
  return {h.rising + h.falling, f64{} + power_error<precise>};
}

/// Returns (t - 1) / (t + 1) for t = e^2x. Beyond 20, the result is constant.
template <int Point>
FIXED_LANE_FUNCTION flat_estimate estimated(of_tanh, f64 x) {
  x = clamp(x * 2, f64{} - 40 * one_in<Point>, f64{} + 40 * one_in<Point>);
  const f64 power = power_of_two<Point>(exponent_of_e<Point>(x), 1);
  return {(power - 1) * one_in<Point> / (power + 1), power_error<Point> * one_in<Point>};
}

template <int Point>
FIXED_LANE_FUNCTION flat_estimate sine(const angle_lanes& angle) {
  // The last bit of the whole number, which is set if it is odd, becomes the sign.
  const f64 sign = f64(i64(angle.whole + 0x1.8p52) << 63);
  return {signed_as(sine_of_half_turns<Point>(angle.t, one_in<Point>), sign),
          sine_error<Point> * one_in<Point>};
}
template <int Point, angle_unit Unit>
FIXED_LANE_FUNCTION flat_estimate estimated(of_sine<Unit>, f64 x) {
  return sine<Point>(half_turns<Point, Unit>(x, 0));
}
template <int Point, angle_unit Unit>
FIXED_LANE_FUNCTION flat_estimate estimated(of_cosine<Unit>, f64 x) {
  return sine<Point>(half_turns<Point, Unit>(x, 0.5));
}

/// A sine divided by a cosine. An error e of both makes an error below e (1 + tangent)^2, which is
/// at most 2 e + 2 e tangent^2.
template <int Point, angle_unit Unit>
FIXED_LANE_FUNCTION growing_estimate estimated(of_tangent<Unit>, f64 x) {
  constexpr double error = 2 * sine_error<precise>;
  const angle_lanes angle = half_turns<Point, Unit>(x, 0);
  const f64 cosine = sine_of_half_turns<precise>(0.5 - magnitude(angle.t), 1);
  const f64 ulps = sine_of_half_turns<precise>(angle.t, one_in<Point>) / cosine;
  return {ulps, magnitude(ulps) * (error / one_in<Point>), error * one_in<Point>,
          bits_below(cosine, f64{} + 0x1p-36)};
}

template <int Point>
FIXED_LANE_FUNCTION flat_estimate estimated(of_atan, f64 x) {
  return {signed_as(angle_of<Point>(magnitude(x), f64{} + one_in<Point>), x), angle_error<Point>};
}

template <int Point>
FIXED_LANE_FUNCTION flat_estimate estimated(of_atan2, f64 y, f64 x) {
  const f64 angle = angle_of<Point>(magnitude(y), magnitude(x));
  return {signed_as(x < 0 ? double_pi * one_in<Point> - angle : angle, y), angle_error<Point>,
          bits_below(magnitude(x) + magnitude(y), f64{} + 1)};
}

/// Returns the other side of a right triangle whose longest side is 2^Point. The result is
/// meaningless for a longer x.
template <int Point>
FIXED_LANE_FUNCTION f64 side_of(f64 x) {
  return root((one_in<Point> - x) * (one_in<Point> + x));
}

template <int Point>
FIXED_LANE_FUNCTION flat_estimate estimated(of_asin, f64 x) {
  return {signed_as(angle_of<Point>(magnitude(x), side_of<Point>(x)), x), angle_error<Point>,
          bits_below(f64{} + one_in<Point>, magnitude(x))};
}

template <int Point>
FIXED_LANE_FUNCTION flat_estimate estimated(of_acos, f64 x) {
  const f64 angle = angle_of<Point>(side_of<Point>(x), magnitude(x));
  return {x < 0 ? double_pi * one_in<Point> - angle : angle, angle_error<Point>,
          bits_below(f64{} + one_in<Point>, magnitude(x))};
}

template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_cbrt, f64 x) {
  constexpr double third = 1.0 / 3;
  const f64 size = magnitude(x);
  const f64 exponent = fused(binary_logarithm<Point>(size), f64{} + third, f64{} - Point * third);
  const f64 whole = nearest_whole(exponent);
  const f64 power = power_of_two<Point>({whole, exponent - whole}, one_in<Point>);
  return {signed_as(power, x), f64{} + 2 * power_error<Point>, 0, bits_below(size, f64{} + 1)};
}

/// The relative error of a few roundings.
inline constexpr double root_error = 0x1p-49;

template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_rsqrt, f64 x) {
  return {one_in<Point> / root(x * (1 / one_in<Point>)), f64{} + root_error, 0,
          bits_below(x, f64{} + 1)};
}

template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_reciprocal, f64 x) {
  return {one_in<Point> * one_in<Point> / x, f64{} + root_error, 0,
          bits_below(magnitude(x), f64{} + 1)};
}

template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_hypot, f64 x, f64 y) {
  return {root(fused(x, x, y * y)), f64{} + root_error};
}

/// Estimates only powers of positive numbers. An error e of the logarithm makes an error |y| e of
/// the exponent.
template <int Point>
FIXED_LANE_FUNCTION growing_estimate estimated(of_pow, f64 x, f64 y) {
  y *= 1 / one_in<Point>;
  const f64 exponent = clamp((binary_logarithm<precise>(x) - Point) * y, f64{} - 40, f64{} + 40);
  const f64 whole = nearest_whole(exponent);
  return {power_of_two<precise>({whole, exponent - whole}, one_in<Point>),
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
  template <class Number, class Function, class Estimate>
  FIXED_LANE_FUNCTION static half_i32 rounded(const Estimate& x, std::uint32_t& unknown) {
    using limits = std::numeric_limits<typename Number::raw_type>;
    constexpr double lowest = (limits::min)();
    constexpr double highest = (limits::max)();
    constexpr double one = one_in<Number::fraction_bits>;
    constexpr bool can_overflow = Function::limit * one > highest;
    unknown = x.unknown;
    f64 ulps = x.ulps;
    if constexpr (can_overflow) {
      if constexpr (Number::rules.range == overflow::trap) {
        unknown |= bits_below(ulps, f64{} + lowest) | bits_below(f64{} + highest, ulps);
      }
      ulps = clamp(ulps, f64{} + lowest, f64{} + highest);
    }
    const f64 whole = nearest_whole(ulps);
    unknown |= undecided(x, ulps, magnitude(ulps - whole));
    return words(whole);
  }

  /// Computes out[i] = Function::scalar(from[i]...), as many as fill whole registers.
  /// @return the number of elements done
  template <class Function, class Number, class... Operands>
  FIXED_LANE_TARGET static std::size_t each(Number* out, std::size_t count,
                                            Operands... from) noexcept(Number::never_throws) {
    using raw = typename Number::raw_type;
    constexpr std::size_t half = width / 2;
    std::size_t i = 0;
    for (; count - i >= half; i += half) {
      std::uint32_t unknown = 0;
      half_i32 result = rounded<Number, Function>(
          estimated<Number::fraction_bits>(Function{}, doubles(load_half<raw>(from, i))...),
          unknown);
      if constexpr (!Number::never_throws) {
        // One by one, so that the elements before one that throws have their results.
        if (unknown != 0) {
          for (std::size_t k = i; k < i + half; ++k) out[k] = Function::scalar(from[k]...);
          continue;
        }
      }
      for (; unknown != 0; unknown &= unknown - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(unknown));
        result[lane] = Function::scalar(from[i + lane]...).raw();
      }
      store<raw>(out, i, result);
    }
    return i;
  }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
