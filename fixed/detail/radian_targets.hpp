/// \file
/// The sines and cosines of fixed/batch_radian.hpp on each path.
#pragma once

#include <cstddef>
#include <cstdint>

#include "fixed/detail/batch_targets.hpp"
#include "fixed/detail/radian.hpp"
#include "fixed/detail/storage.hpp"

namespace fixed::detail {

template <int F>
void nearest_sines(const raw_t<F>* angles, raw_t<F>* results, std::size_t count,
                   std::uint64_t ahead) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    results[i] = static_cast<raw_t<F>>(nearest_sine<F>(angles[i], ahead));
  }
}

template <int F>
void nearest_of_both(const raw_t<F>* angles, raw_t<F>* cosines, raw_t<F>* sines,
                     std::size_t count) noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    const raw_t<F> angle = angles[i];
    cosines[i] = static_cast<raw_t<F>>(nearest_sine<F>(angle, quarter_turn));
    sines[i] = static_cast<raw_t<F>>(nearest_sine<F>(angle, 0));
  }
}

}  // namespace fixed::detail

#define FIXED_RADIAN_FUNCTION FIXED_RADIAN_TARGET __attribute__((always_inline)) inline

#if defined(FIXED_BATCH_X86)

#define FIXED_RADIAN_LANES radian_avx2
#define FIXED_RADIAN_BYTES 32
#define FIXED_RADIAN_TARGET __attribute__((target("avx2")))
#include "fixed/detail/radian_lanes.hpp"
#undef FIXED_RADIAN_LANES
#undef FIXED_RADIAN_BYTES
#undef FIXED_RADIAN_TARGET

#define FIXED_RADIAN_LANES radian_avx512
#define FIXED_RADIAN_BYTES 64
#define FIXED_RADIAN_TARGET __attribute__((target("avx512f")))
#include "fixed/detail/radian_lanes.hpp"
#undef FIXED_RADIAN_LANES
#undef FIXED_RADIAN_BYTES
#undef FIXED_RADIAN_TARGET

#elif defined(FIXED_BATCH_NEON)
#define FIXED_RADIAN_LANES radian_neon
#define FIXED_RADIAN_BYTES 16
#define FIXED_RADIAN_TARGET
#include "fixed/detail/radian_lanes.hpp"
#undef FIXED_RADIAN_LANES
#undef FIXED_RADIAN_BYTES
#undef FIXED_RADIAN_TARGET
#endif

#undef FIXED_RADIAN_FUNCTION

namespace fixed::detail {

/// nearest_sine() of every angle; `results` may be `angles`. A path that is not to be had is
/// replaced by the portable one.
template <int F>
void all_sines(batch::path use, const raw_t<F>* angles, raw_t<F>* results, std::size_t count,
               std::uint64_t ahead) noexcept {
  std::size_t done = 0;
  static_cast<void>(use);
#if defined(FIXED_BATCH_X86)
  if (use == batch::path::avx512 && batch::has(use)) {
    done = radian_avx512::sines<F>(angles, results, count, ahead);
  } else if (use == batch::path::avx2 && batch::has(use)) {
    done = radian_avx2::sines<F>(angles, results, count, ahead);
  }
#elif defined(FIXED_BATCH_NEON)
  if (use == batch::path::neon) done = radian_neon::sines<F>(angles, results, count, ahead);
#endif
  nearest_sines<F>(angles + done, results + done, count - done, ahead);
}

/// Both of every angle; one of the results may be `angles`.
template <int F>
void all_of_both(batch::path use, const raw_t<F>* angles, raw_t<F>* cosines, raw_t<F>* sines,
                 std::size_t count) noexcept {
  std::size_t done = 0;
  static_cast<void>(use);
#if defined(FIXED_BATCH_X86)
  if (use == batch::path::avx512 && batch::has(use)) {
    done = radian_avx512::both<F>(angles, cosines, sines, count);
  } else if (use == batch::path::avx2 && batch::has(use)) {
    done = radian_avx2::both<F>(angles, cosines, sines, count);
  }
#elif defined(FIXED_BATCH_NEON)
  if (use == batch::path::neon) done = radian_neon::both<F>(angles, cosines, sines, count);
#endif
  nearest_of_both<F>(angles + done, cosines + done, sines + done, count - done);
}

/// The stored integers of numbers that lie one after the other: a number consists of nothing else.
template <class Number>
auto raws(Number* numbers) noexcept {
  static_assert(sizeof(Number) == sizeof(typename Number::raw_type));
  return reinterpret_cast<typename Number::raw_type*>(numbers);
}
template <class Number>
auto raws(const Number* numbers) noexcept {
  static_assert(sizeof(Number) == sizeof(typename Number::raw_type));
  return reinterpret_cast<const typename Number::raw_type*>(numbers);
}

}  // namespace fixed::detail
