/// Measures the errors of the estimates of fixed/batch/detail/function_lanes.hpp next to their
/// bounds, in every rounding mode.
#include <cmath>
#include <limits>

#include "fixed/batch/functions.hpp"
#include "fixed/formats.hpp"
#include "tests/support/rounding_mode.hpp"
#include "tests/support/test.hpp"

// The exact results come from long double, which needs more bits than double.
#if defined(FIXED_BATCH_X86) && LDBL_MANT_DIG >= 64

namespace fixproof::detail {
namespace {

using exact = long double;

/// One lane of an estimate.
struct Lane {
  double ulps;
  double bound;
  bool is_known;
};

/// Returns x. Compilers do not move the read to another rounding mode.
double unmoved(double x) {
  const volatile double copy = x;
  return copy;
}

#define ESTIMATES(set, target)                                                               \
  namespace set##_test {                                                                     \
    target double bound_of(const set::flat_estimate& x) { return x.error; }                  \
    target double bound_of(const set::growing_estimate& x) {                                 \
      return std::fabs(x.ulps[0]) * x.relative[0] + x.error;                                 \
    }                                                                                        \
    template <class Function, int F, class... Words>                                         \
    target Lane lane(Words... words) {                                                       \
      const auto estimate = set::estimated<F>(Function{}, (set::f64{} + unmoved(words))...); \
      return {estimate.ulps[0], bound_of(estimate), (estimate.unknown & 1) == 0};            \
    }                                                                                        \
  }
ESTIMATES(avx2, __attribute__((target("avx2,fma"))))
ESTIMATES(avx512, __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"))))
#undef ESTIMATES

/// Whether both are out of the range of 32 bits, or both round to zero whatever their error.
bool are_flat(double ulps, exact want) {
  constexpr double range = 0x1p31;
  const auto magnitude = static_cast<double>(std::fabs(want));
  return (std::fabs(ulps) > range && magnitude > range) ||
         (std::fabs(ulps) < 0.25 && magnitude < 0.25);
}

/// Expects errors of at most half the bounds.
template <class Function, int F, class Exact, class... Words>
void expect_half(const char* name, const Exact& function, Words... words) {
  constexpr auto one = static_cast<exact>(one_in<F>);
  const exact want = function(static_cast<exact>(words) / one...) * one;
  if (!std::isfinite(want)) return;
  const auto expect = [&](const Lane& lane, int mode) {
    if (!lane.is_known || are_flat(lane.ulps, want)) return;
    ASSERT_LE(std::fabs(static_cast<exact>(lane.ulps) - want), static_cast<exact>(lane.bound / 2))
        << name << " of raw " << testing::PrintToString(std::tuple(words...)) << ", F = " << F
        << ", rounding mode " << mode;
  };
  // The library is exact enough only to nearest, so it has computed `want` before.
  for (const int mode : RoundingMode::all) {
    const RoundingMode set(mode);
    if (batch::has(batch::path::avx512)) expect(avx512_test::lane<Function, F>(words...), mode);
    if (batch::has(batch::path::avx2)) expect(avx2_test::lane<Function, F>(words...), mode);
  }
}

template <class Function, int F, int operands, class Exact>
void expect_half_of_many(const char* name, const Exact& function) {
  std::mt19937 random(5);
  const auto word = [&random] {
    const auto magnitude = static_cast<double>(random() >> (1 + random() % 31));
    return random() % 2 == 0 ? magnitude : 0 - magnitude;
  };
  for (int i = 0; i < 10'000 && !testing::Test::HasFatalFailure(); ++i) {
    const double x = word();
    if constexpr (operands == 1) {
      expect_half<Function, F>(name, function, x);
    } else {
      expect_half<Function, F>(name, function, x, word());
    }
  }
}

template <int F, angle_unit Unit>
void expect_half_of_angles(exact period) {
  const auto radians = [period](exact x) {
    constexpr exact pi = 3.14159265358979323846264338327950288L;
    return Unit == angle_unit::radian ? x : std::remainder(x, period) * (2 * pi / period);
  };
  expect_half_of_many<of_sine<Unit>, F, 1>("sin", [&](exact x) { return std::sin(radians(x)); });
  expect_half_of_many<of_cosine<Unit>, F, 1>("cos", [&](exact x) { return std::cos(radians(x)); });
  expect_half_of_many<of_tangent<Unit>, F, 1>("tan", [&](exact x) { return std::tan(radians(x)); });
}

template <int F>
void expect_half_of_all() {
  expect_half_of_many<of_exp, F, 1>("exp", [](exact x) { return std::exp(x); });
  expect_half_of_many<of_exp2, F, 1>("exp2", [](exact x) { return std::exp2(x); });
  expect_half_of_many<of_expm1, F, 1>("expm1", [](exact x) { return std::expm1(x); });
  expect_half_of_many<of_log, F, 1>("log", [](exact x) { return std::log(x); });
  expect_half_of_many<of_log2, F, 1>("log2", [](exact x) { return std::log2(x); });
  expect_half_of_many<of_log10, F, 1>("log10", [](exact x) { return std::log10(x); });
  expect_half_of_many<of_log1p, F, 1>("log1p", [](exact x) { return std::log1p(x); });
  expect_half_of_many<of_sinh, F, 1>("sinh", [](exact x) { return std::sinh(x); });
  expect_half_of_many<of_cosh, F, 1>("cosh", [](exact x) { return std::cosh(x); });
  expect_half_of_many<of_tanh, F, 1>("tanh", [](exact x) { return std::tanh(x); });
  expect_half_of_angles<F, angle_unit::radian>(0);
  expect_half_of_angles<F, angle_unit::degree>(360);
  expect_half_of_angles<F, angle_unit::turn>(1);
  expect_half_of_many<of_atan, F, 1>("atan", [](exact x) { return std::atan(x); });
  expect_half_of_many<of_asin, F, 1>("asin", [](exact x) { return std::asin(x); });
  expect_half_of_many<of_acos, F, 1>("acos", [](exact x) { return std::acos(x); });
  expect_half_of_many<of_cbrt, F, 1>("cbrt", [](exact x) { return std::cbrt(x); });
  expect_half_of_many<of_rsqrt, F, 1>("rsqrt", [](exact x) { return 1 / std::sqrt(x); });
  expect_half_of_many<of_reciprocal, F, 1>("reciprocal", [](exact x) { return 1 / x; });
  expect_half_of_many<of_atan2, F, 2>("atan2", [](exact y, exact x) { return std::atan2(y, x); });
  expect_half_of_many<of_hypot, F, 2>("hypot", [](exact x, exact y) { return std::hypot(x, y); });
  expect_half_of_many<of_pow, F, 2>("pow", [](exact x, exact y) { return std::pow(x, y); });
}

TEST(BatchEstimates, HaveHalfTheirBound) {
  expect_half_of_all<0>();
  expect_half_of_all<8>();
  expect_half_of_all<16>();
  expect_half_of_all<24>();
  expect_half_of_all<30>();
  expect_half_of_all<32>();
}

}  // namespace
}  // namespace fixproof::detail
#endif
