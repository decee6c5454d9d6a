/// \file
/// Sines and cosines of many angles in radians: the results of fixed/trig.hpp, to the bit, several
/// times as fast where the processor has AVX2, AVX-512 or NEON. Not part of fixed/fixed.hpp.
///
/// Paths are those of fixed/batch.hpp.
#pragma once

#include <algorithm>
#include <array>  // std::data, std::size
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/batch_targets.hpp"
#include "fixed/detail/radian.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"

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

/// Functions of many numbers at once.
namespace fixed::batch {

/// results[i] = fixed::sin(angles[i]), for arrays, vectors, spans and the like of numbers of one
/// type. As many as the shorter has; both may be the same, but not overlap otherwise.
///
///     std::vector<fixed::q16_16> angles(1000), sines(1000);
///     fixed::batch::sin(angles, sines);
template <detail::number_range Angles, detail::number_range Results>
requires std::same_as<detail::element_t<Angles>, detail::element_t<Results>>
void sin(const Angles& angles, Results&& results, path use = best()) noexcept {
  constexpr int bits = detail::element_t<Angles>::fraction_bits;
  const std::size_t count = std::min<std::size_t>(std::size(angles), std::size(results));
  detail::all_sines<bits>(use, detail::raws(std::data(angles)), detail::raws(std::data(results)),
                          count, 0);
}

/// As sin(), with fixed::cos.
template <detail::number_range Angles, detail::number_range Results>
requires std::same_as<detail::element_t<Angles>, detail::element_t<Results>>
void cos(const Angles& angles, Results&& results, path use = best()) noexcept {
  constexpr int bits = detail::element_t<Angles>::fraction_bits;
  const std::size_t count = std::min<std::size_t>(std::size(angles), std::size(results));
  detail::all_sines<bits>(use, detail::raws(std::data(angles)), detail::raws(std::data(results)),
                          count, detail::quarter_turn);
}

/// cosines[i] and sines[i] = fixed::sin_cos(angles[i]), as sin() otherwise. The angles may be where
/// one of the results is to be.
template <detail::number_range Angles, detail::number_range Cosines, detail::number_range Sines>
requires std::same_as<detail::element_t<Angles>, detail::element_t<Cosines>> &&
    std::same_as<detail::element_t<Angles>, detail::element_t<Sines>>
void sin_cos(const Angles& angles, Cosines&& cosines, Sines&& sines, path use = best()) noexcept {
  constexpr int bits = detail::element_t<Angles>::fraction_bits;
  const std::size_t count = std::min<std::size_t>(
      std::size(angles), std::min<std::size_t>(std::size(cosines), std::size(sines)));
  detail::all_of_both<bits>(use, detail::raws(std::data(angles)), detail::raws(std::data(cosines)),
                            detail::raws(std::data(sines)), count);
}

}  // namespace fixed::batch
