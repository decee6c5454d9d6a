/// @file
/// Sines and cosines of many angles in radians, bit-identical to fixed/sine.hpp and several times
/// as fast with AVX2 or AVX-512. NEON registers compute them, too. Not part of fixed/fixed.hpp.
///
/// Spans and paths are those of fixed/batch/batch.hpp.
#pragma once

#include <array>  // std::data, std::size
#include <cstddef>
#include <cstdint>

#include "fixed/batch/detail/spans.hpp"
#include "fixed/batch/detail/targets.hpp"
#include "fixed/detail/radian.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/math.hpp"

namespace fixproof::detail {

/// Whether this header computes the sines of numbers Number.
template <class Number>
inline constexpr bool has_radians_of =
    has_radians<typename Number::raw_type, Number::fraction_bits, Number::rules>;

template <class Number>
constexpr void check_radians() noexcept {
  static_assert(
      has_radians_of<Number>,
      "radians need 16.16 or 8.8: for others, call sin and cos of fixed/batch/functions.hpp");
}

/// Up to this many angles are faster one by one.
inline constexpr std::size_t few_angles = 2;

/// The sines of `count` angles, each advanced by `ahead` / 2^64 turns.
template <class Number>
void sines(batch::path use, const Number* from, Number* to, std::size_t count,
           std::uint64_t ahead) noexcept {
  check_radians<Number>();
  constexpr int Point = Number::fraction_bits;
  std::size_t i = 0;
  if (count > few_angles) {
    i = on_path<has_radians_of<Number>>(use, [&](auto on) {
      return on.template sines<typename Number::raw_type, Point>(from, to, count, ahead);
    });
  }
  for (; i < count; ++i) {
    to[i] = Number::from_raw(
        static_cast<typename Number::raw_type>(nearest_sine<Point>(from[i].raw(), ahead)));
  }
}

}  // namespace fixproof::detail

/// Functions over many numbers.
namespace fixproof::batch {

/// results[i] = fixproof::sin(angles[i]), up to the length of the shorter span. The spans may be
/// the same. If they overlap in any other way, the results are unspecified.
///
///     std::vector<fixproof::q16_16> angles(1000), sines(1000);
///     fixproof::batch::sin(angles, sines);
template <detail::number_range Angles, detail::output_of<detail::element_t<Angles>> Results>
void sin(const Angles& angles, Results&& results, path use = path::fastest) noexcept {
  const std::size_t count = detail::shortest(angles, results);
  detail::sines(use, std::data(angles), std::data(results), count, 0);
}

/// results[i] = fixproof::cos(angles[i]); see sin().
template <detail::number_range Angles, detail::output_of<detail::element_t<Angles>> Results>
void cos(const Angles& angles, Results&& results, path use = path::fastest) noexcept {
  const std::size_t count = detail::shortest(angles, results);
  detail::sines(use, std::data(angles), std::data(results), count, detail::quarter_turn);
}

/// sines[i] and cosines[i] = fixproof::sin_cos(angles[i]); see sin(). One result may overwrite the
/// angles.
template <detail::number_range Angles, detail::output_of<detail::element_t<Angles>> Sines,
          detail::output_of<detail::element_t<Angles>> Cosines>
void sin_cos(const Angles& angles, Sines&& sines, Cosines&& cosines,
             path use = path::fastest) noexcept {
  using Number = detail::element_t<Angles>;
  using raw = typename Number::raw_type;
  detail::check_radians<Number>();
  constexpr int Point = Number::fraction_bits;
  const Number* const from = std::data(angles);
  Number* const to_cos = std::data(cosines);
  Number* const to_sin = std::data(sines);
  const std::size_t count = detail::shortest(angles, cosines, sines);
  std::size_t i = 0;
  if (count > detail::few_angles) {
    i = detail::on_path<true>(use, [&](auto on) {
      return on.template sines_and_cosines<raw, Point>(from, to_cos, to_sin, count);
    });
  }
  for (; i < count; ++i) {
    const std::int32_t angle = from[i].raw();
    using detail::nearest_sine;
    to_cos[i] =
        Number::from_raw(static_cast<raw>(nearest_sine<Point>(angle, detail::quarter_turn)));
    to_sin[i] = Number::from_raw(static_cast<raw>(nearest_sine<Point>(angle, 0)));
  }
}

/// @cond
FIXED_REFUSED_RANGES(void, sin, "a path")
FIXED_REFUSED_RANGES(void, cos, "a path")
FIXED_REFUSED_RANGES(void, sin_cos, "a path")
/// @endcond

}  // namespace fixproof::batch
