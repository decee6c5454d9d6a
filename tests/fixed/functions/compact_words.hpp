/// @file
/// The compact functions beside those in words, which are compared with the oracle.
#pragma once

#include "fixed/detail/arcsine.hpp"
#include "fixed/detail/compact_angle.hpp"
#include "fixed/detail/compact_exponential.hpp"
#include "fixed/detail/compact_phase.hpp"
#include "fixed/detail/compact_power.hpp"
#include "fixed/detail/hyperbolic.hpp"
#include "fixed/detail/phase.hpp"
#include "fixed/detail/power.hpp"
#include "fixed/detail/variant.hpp"
#include "fixed/formats.hpp"
#include "tests/support/test.hpp"

namespace functions {

namespace words = fixproof::detail;
namespace compact = fixproof::detail::in_compact_words;
using fixproof::rounding;
using words::angle_unit;
using words::exponential_base;
using words::hyperbola;
using words::logarithm_base;
using words::triangle_side;

/// A function of x, y and the bits after their points, in words and in compact words. The bits of
/// the compact one are a result_bits, which says what 64 bits decide.
template <class Bits>
struct InBoth {
  const char* name;
  bool (*takes)(std::int64_t x, int bits);
  std::int64_t (*in_words)(std::int64_t, std::int64_t, int);
  std::int64_t (*in_compact_words)(std::int64_t, std::int64_t, Bits);
};

inline bool any(std::int64_t /*x*/, int /*bits*/) { return true; }
inline bool is_positive(std::int64_t x, int /*bits*/) { return x > 0; }
inline bool is_in_unit(std::int64_t x, int bits) { return std::abs(x) <= std::int64_t{1} << bits; }
template <angle_unit Unit>
bool is_no_pole(std::int64_t x, int bits) {
  return !words::is_pole<Unit>(x, bits);
}
inline std::uint64_t magnitude(std::int64_t x) { return static_cast<std::uint64_t>(std::abs(x)); }

/// x in units of 2^-32 and limited to +-64, as the functions of exponential.hpp take it.
inline std::int64_t units(std::int64_t x, int bits) {
  const std::int64_t limit = std::int64_t{64} << bits;
  return std::clamp(x, -limit, limit) * (std::int64_t{1} << (32 - bits));
}

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the same call in two namespaces
#define BOTH(name, takes, ...)                                                          \
  InBoth<Bits> {                                                                        \
    name, takes,                                                                        \
        []([[maybe_unused]] std::int64_t x, [[maybe_unused]] std::int64_t y,            \
           [[maybe_unused]] int bits) -> std::int64_t { return words::__VA_ARGS__; },   \
        []([[maybe_unused]] std::int64_t x, [[maybe_unused]] std::int64_t y,            \
           [[maybe_unused]] Bits bits) -> std::int64_t { return compact::__VA_ARGS__; } \
  }

template <class Bits, rounding Ties>
inline const std::array functions_in_both{
    BOTH("exp2", any, nearest_exponential<exponential_base::two, Ties>(units(x, bits), bits)),
    BOTH("exp", any, nearest_exponential<exponential_base::e, Ties>(units(x, bits), bits)),
    BOTH("sinh", any, nearest_hyperbolic<hyperbola::sine>(units(std::abs(x), bits), bits)),
    BOTH("cosh", any, nearest_hyperbolic<hyperbola::cosine>(units(std::abs(x), bits), bits)),
    BOTH("tanh", any, nearest_hyperbolic_tangent(units(std::abs(x), bits), bits)),
    BOTH("log2", is_positive, nearest_logarithm<logarithm_base::two>(magnitude(x), bits, bits)),
    BOTH("log", is_positive, nearest_logarithm<logarithm_base::e>(magnitude(x), bits, bits)),
    BOTH("log10", is_positive, nearest_logarithm<logarithm_base::ten>(magnitude(x), bits, bits)),
    BOTH("sin", any, nearest_sine_of<angle_unit::radian, Ties>(x, 0, bits, bits)),
    BOTH("cos", any, nearest_sine_of<angle_unit::radian, Ties>(x, 1, bits, bits)),
    BOTH("sin_of_degrees", any, nearest_sine_of<angle_unit::degree, Ties>(x, 0, bits, bits)),
    BOTH("cos_of_degrees", any, nearest_sine_of<angle_unit::degree, Ties>(x, 1, bits, bits)),
    BOTH("sin_of_turns", any, nearest_sine_of<angle_unit::turn, Ties>(x, 0, bits, bits)),
    BOTH("cos_of_turns", any, nearest_sine_of<angle_unit::turn, Ties>(x, 1, bits, bits)),
    BOTH("tan", any, nearest_tangent<angle_unit::radian>(x, bits, bits)),
    BOTH("pole of degrees", any, is_pole<angle_unit::degree>(x, bits) ? 1 : 0),
    BOTH("pole of turns", any, is_pole<angle_unit::turn>(x, bits) ? 1 : 0),
    BOTH("tan_of_degrees", is_no_pole<angle_unit::degree>,
         nearest_tangent<angle_unit::degree>(x, bits, bits)),
    BOTH("tan_of_turns", is_no_pole<angle_unit::turn>,
         nearest_tangent<angle_unit::turn>(x, bits, bits)),
    BOTH("asin", is_in_unit, nearest_triangle_angle<triangle_side::sine>(x, bits, bits)),
    BOTH("acos", is_in_unit, nearest_triangle_angle<triangle_side::cosine>(x, bits, bits)),
    BOTH("atan", any, nearest_angle(x, std::int64_t{1} << bits, bits)),
    BOTH("atan2", any, nearest_angle(y, x, bits)),
    BOTH("cbrt", any, nearest_cube_root(magnitude(x), bits)),
    BOTH("rsqrt", is_positive, nearest_reciprocal_root<Ties>(magnitude(x), bits)),
};
#undef BOTH

/// Whether a function has the same result in both. Beyond every format, results may differ.
template <class Bits>
bool is_same(const InBoth<Bits>& function, std::int64_t x, std::int64_t y) {
  if (!function.takes(x, Bits())) return true;
  constexpr std::int64_t beyond = std::int64_t{1} << 33;
  return std::clamp(function.in_words(x, y, Bits()), -beyond, beyond) ==
         std::clamp(function.in_compact_words(x, y, Bits()), -beyond, beyond);
}

template <class N, rounding Ties = rounding::half_up>
void expect_same_in_both(std::int64_t x, std::int64_t y) {
  for (const auto& function : functions_in_both<words::result_bits<N, N>, Ties>) {
    ASSERT_TRUE(is_same(function, x, y))
        << function.name << " of " << x << ' ' << y << ' ' << N::fraction_bits;
  }
}

}  // namespace functions
