/// \file
/// Instantiates batch/detail/function_lanes.hpp for each instruction set, and selects one.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "batch/detail/polynomials.hpp"
#include "batch/detail/targets.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/detail/phase.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The stored integer of 1.
template <int F>
inline constexpr double one_in = std::uint64_t{1} << F;

/// Returns `few` for formats of at most 16 fraction bits, else `many`.
template <int F, class Few, class Many>
constexpr auto by_precision(const Few& few, const Many& many) noexcept {
  if constexpr (F <= 16) {
    return few;
  } else {
    return many;
  }
}

template <angle_unit Unit>
inline constexpr std::array<double, 2> half_turns_per =
    Unit == angle_unit::radian   ? half_turns_per_radian
    : Unit == angle_unit::degree ? half_turns_per_degree
                                 : std::array<double, 2>{2, 0};

// The functions as tags. No magnitude of a result is above the limit.
struct unlimited {
  static constexpr double limit = 0x1p100;
};
template <int Limit>
struct limited_to {
  static constexpr double limit = Limit;
};
struct of_exp : unlimited {};
struct of_exp2 : unlimited {};
struct of_expm1 : unlimited {};
struct of_sinh : unlimited {};
struct of_cosh : unlimited {};
struct of_cbrt : unlimited {};
struct of_rsqrt : unlimited {};
struct of_reciprocal : unlimited {};
struct of_hypot : unlimited {};
struct of_pow : unlimited {};
struct of_log : limited_to<32> {};
struct of_log2 : limited_to<32> {};
struct of_log10 : limited_to<32> {};
struct of_log1p : limited_to<32> {};
struct of_tanh : limited_to<1> {};
struct of_atan : limited_to<2> {};
struct of_atan2 : limited_to<4> {};
struct of_asin : limited_to<2> {};
struct of_acos : limited_to<4> {};
template <angle_unit Unit>
struct of_sine : limited_to<1> {};
template <angle_unit Unit>
struct of_cosine : limited_to<1> {};
template <angle_unit Unit>
struct of_tangent : unlimited {};

}  // namespace fixproof::detail

#if defined(FIXED_BATCH_X86)
#define FIXED_LANES avx2
#define FIXED_LANE_BYTES 32  // NOLINT(cppcoreguidelines-macro-usage): undefined below
#define FIXED_LANE_TARGET __attribute__((target("avx2,fma")))
#include "batch/detail/function_parts.hpp"

#define FIXED_LANES avx512
#define FIXED_LANE_BYTES 64  // NOLINT(cppcoreguidelines-macro-usage): undefined below
#define FIXED_LANE_TARGET __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl")))
#include "batch/detail/function_parts.hpp"

#elif defined(FIXED_BATCH_NEON)
#define FIXED_LANES neon
#define FIXED_LANE_BYTES 16
#define FIXED_LANE_TARGET
#include "batch/detail/function_parts.hpp"
#endif

namespace fixproof::detail {

/// As on_path(), for functions, which need exact doubles, and a fused multiply-add with AVX2.
template <bool has, class Call>
std::size_t on_function_path(batch::path which, const Call& call) {
  if constexpr (has && hardware_double) {
#if defined(FIXED_BATCH_X86)
    if (which == batch::path::avx512 && batch::has(which)) return call(avx512::functions{});
    if (which == batch::path::avx2 && batch::has(which) &&
        static_cast<bool>(__builtin_cpu_supports("fma"))) {
      return call(avx2::functions{});
    }
#elif defined(FIXED_BATCH_NEON)
    if (which == batch::path::neon) return call(neon::functions{});
#endif
  }
  (void)which;
  (void)call;
  return 0;
}

}  // namespace fixproof::detail
