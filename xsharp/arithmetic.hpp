/// @file
/// The requirements on a number type: the operators + - * and <, an explicit conversion to double,
/// and a specialisation of Arithmetic.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "fixed/fixed.hpp"
#include "xsharp/scene.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// The cosine and sine of an angle.
template <class N>
struct Turn {
  N cos{};
  N sin{};

  friend constexpr bool operator==(const Turn&, const Turn&) = default;
};

inline double radians(std::int32_t tenths) { return tenths * (std::numbers::pi / 1800.0); }

/// A constant in 16.16, in units of 2^-16. Saturates; NaN becomes 0.
inline std::int32_t raw_constant(double value, Conversion conversion) {
  const double units = value * 65536.0 + 0.5;
  const double whole = conversion == Conversion::published ? std::trunc(units) : std::floor(units);
  using limits = std::numeric_limits<std::int32_t>;
  if (std::isnan(whole)) return 0;
  if (whole <= limits::min()) return limits::min();
  if (whole >= limits::max()) return limits::max();
  return static_cast<std::int32_t>(whole);
}

/// a + b as the 8088 ConcatXforms computes it: fractions and whole parts are added separately,
/// without a carry. If the fractions add up to 1 or more, the result is 1 too low.
template <class Raw, int F, fixproof::policy P>
constexpr fixproof::number<Raw, F, P> sum_in_parts(fixproof::number<Raw, F, P> a,
                                                   fixproof::number<Raw, F, P> b) {
  const fixproof::number<Raw, F, P> sum = a + b;
  return fixproof::floor(a) + fixproof::floor(b) + (sum - fixproof::floor(sum));
}

/// Whether the policy is one of the four 8088 builds of FIXED.ASM.
constexpr bool is_i8088_build(const fixproof::policy& p) {
  using namespace fixproof::policies;
  return p == i8088_rounded || p == i8088_mul_rounded || p == i8088_div_rounded ||
         p == i8088_unrounded;
}

/// The interface of the pipeline to a number type. A specialisation has:
///
///     static std::int32_t raw(N);               in units of 2^-16, nearest
///     static N from_raw(std::int32_t);
///     static N constant(double, Conversion);    computed in double
///     static std::optional<N> divide(N n, N d); nothing for a divide error
///     static bool divides_by_whole_part();      whether divide drops the fraction of d
///     static Turn<N> turn(std::int32_t tenths); from the table of cosines
///     static N midpoint(N, N);                  between them, or one of two neighbours
///     static Vec3<N> apply(const Transform<N>&, const Vec3<N>&);
///     static Transform<N> concatenate(const Transform<N>& first,
///                                     const Transform<N>& second, Concatenation);
///     static N length(const Vec3<N>&);          to nearest; below 32768
///     static N power(N base, N exponent);       to nearest; base above 0
///
/// Motion needs only from_raw, constant, divide, divides_by_whole_part, turn and length.
template <class N>
struct Arithmetic;

/// The verified type, under any of its policies.
template <fixproof::policy P>
struct Arithmetic<fixproof::number<std::int32_t, 16, P>> {
  using N = fixproof::number<std::int32_t, 16, P>;

  static constexpr std::int32_t raw(N x) { return x.raw(); }
  static constexpr N from_raw(std::int32_t raw) { return N::from_raw(raw); }
  static N constant(double value, Conversion conversion) {
    return N::from_raw(raw_constant(value, conversion));
  }
  static constexpr std::optional<N> divide(N n, N d) { return fixproof::try_divide(n, d); }
  static constexpr bool divides_by_whole_part() {
    return P.divisor == fixproof::divisor_width::whole_part;
  }
  static constexpr Turn<N> turn(std::int32_t tenths) {
    const auto [sin, cos] = fixproof::sin_cos_of_tenths<N>(tenths);
    return {cos, sin};
  }
  static constexpr N midpoint(N a, N b) { return N::from_raw(std::midpoint(a.raw(), b.raw())); }
  static constexpr Vec3<N> apply(const Transform<N>& t, const Vec3<N>& v) {
    return apply_products(t, v);
  }
  static constexpr Transform<N> concatenate(const Transform<N>& first, const Transform<N>& second,
                                            Concatenation how) {
    if constexpr (is_i8088_build(P)) {
      if (how == Concatenation::published) {
        return concatenate_products(first, second, [](N a, N b) { return sum_in_parts(a, b); });
      }
    }
    return concatenate_products(first, second);
  }
  static constexpr N length(const Vec3<N>& v) { return fixproof::hypot(v.x, v.y, v.z); }
  static constexpr N power(N base, N exponent) { return fixproof::pow(base, exponent); }
};

/// double, which is the reference, and float. Neither rounds constants, sines or cosines to 16.16.
/// Lengths and powers are those of the C++ library, which may be the neighbour of the nearest.
template <std::floating_point N>
struct Arithmetic<N> {
  static std::int32_t raw(N x) { return raw_constant(static_cast<double>(x), Conversion::nearest); }
  static N from_raw(std::int32_t raw) { return static_cast<N>(raw / 65536.0); }
  static N constant(double value, Conversion /*conversion*/) { return static_cast<N>(value); }
  static std::optional<N> divide(N n, N d) { return d == 0 ? std::nullopt : std::optional(n / d); }
  static constexpr bool divides_by_whole_part() { return false; }
  static Turn<N> turn(std::int32_t tenths) {
    return {static_cast<N>(std::cos(radians(tenths))), static_cast<N>(std::sin(radians(tenths)))};
  }
  static N midpoint(N a, N b) { return std::midpoint(a, b); }
  static Vec3<N> apply(const Transform<N>& t, const Vec3<N>& v) { return apply_products(t, v); }
  static Transform<N> concatenate(const Transform<N>& first, const Transform<N>& second,
                                  Concatenation /*how*/) {
    return concatenate_products(first, second);
  }
  static N length(const Vec3<N>& v) { return std::hypot(v.x, v.y, v.z); }
  static N power(N base, N exponent) { return std::pow(base, exponent); }
};

template <class N>
concept Scalar = std::totally_ordered<N> && requires(N a, std::int32_t i) {
  { a + a } -> std::same_as<N>;
  // NOLINTNEXTLINE(misc-redundant-expression): only the type counts
  { a - a } -> std::same_as<N>;
  { -a } -> std::same_as<N>;
  { a* a } -> std::same_as<N>;
  static_cast<double>(a);
  { Arithmetic<N>::from_raw(i) } -> std::same_as<N>;
};

/// A whole number in range.
template <Scalar N>
N from_whole(std::int32_t value) {
  return Arithmetic<N>::from_raw(value * 65536);
}

/// Whole numbers are exact (the listings shift them left); others go through `conversion`. In
/// double, a coordinate is unchanged.
template <Scalar N>
N coordinate(double value, Conversion conversion) {
  const bool whole = value == std::trunc(value);
  return Arithmetic<N>::constant(value, whole ? Conversion::nearest : conversion);
}

/// A vertex of a mesh in 16.16; see Mesh::computed.
template <Scalar N>
Vec3<N> vertex_of(const Mesh& mesh, const Triple& v, Conversion conversion) {
  const auto number = [&](double value) {
    return mesh.computed ? Arithmetic<N>::constant(value, conversion)
                         : coordinate<N>(value, conversion);
  };
  return {number(v[0]), number(v[1]), number(v[2])};
}

/// floor(x + 1/2): a position in pixels, rounded half up.
/// @param x at least 0.5 from the ends of the range
template <Scalar N>
std::int32_t nearest_pixel(N x) {
  if constexpr (std::floating_point<N>) {
    return static_cast<std::int32_t>(std::floor(x + N{0.5}));
  } else {
    return static_cast<std::int32_t>((std::int64_t{Arithmetic<N>::raw(x)} + 0x8000) >> 16);
  }
}

template <Scalar N>
Transform<N> identity() {
  Transform<N> t;
  for (std::size_t i = 0; i < 3; ++i) t.rows[i][i] = from_whole<N>(1);
  return t;
}

}  // namespace xsharp
