/// @file
/// Instantiates fixed/batch/detail/function_lanes.hpp for each instruction set, and selects one.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "fixed/batch/detail/function_tags.hpp"
#include "fixed/batch/detail/polynomials.hpp"
#include "fixed/batch/detail/targets.hpp"
#include "fixed/detail/hardware.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The stored integer of 1.
template <int Point>
inline constexpr double one_in = std::uint64_t{1} << Point;

/// Returns `few` for formats of at most 16 fraction bits, else `many`.
template <int Point, class Few, class Many>
constexpr auto by_precision(const Few& few, const Many& many) noexcept {
  if constexpr (Point <= 16) {
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

}  // namespace fixproof::detail

#if defined(FIXED_BATCH_X86)
#define FIXED_LANES avx2
#define FIXED_LANE_BYTES 32  // NOLINT(cppcoreguidelines-macro-usage): undefined below
#define FIXED_LANE_TARGET __attribute__((target("avx2,fma")))
#include "fixed/batch/detail/function_parts.hpp"

#define FIXED_LANES avx512
#define FIXED_LANE_BYTES 64  // NOLINT(cppcoreguidelines-macro-usage): undefined below
#define FIXED_LANE_TARGET __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl")))
#include "fixed/batch/detail/function_parts.hpp"

#elif defined(FIXED_BATCH_NEON)
#define FIXED_LANES neon
#define FIXED_LANE_BYTES 16
#define FIXED_LANE_TARGET
#include "fixed/batch/detail/function_parts.hpp"
#endif

namespace fixproof::detail {

/// As on_path(), for functions, which need exact doubles, and a fused multiply-add with AVX2.
template <bool has, class Call>
std::size_t on_function_path(batch::path which, const Call& call) {
  if constexpr (has && hardware_double) {
    if (which == batch::path::fastest) which = batch::best();
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
